package daphnis.core.engine

import daphnis.core.Simulation
import daphnis.core.population.stateDigest
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Advances [simulation]; what was thrown, or null. */
fun failure(simulation: Simulation): String? = try {
    simulation.advance()
    null
} catch (e: RuntimeException) {
    "${e.javaClass.name}: ${e.message}"
}

/** Asserts that both have the same digest, counts and record of collisions. */
fun assertSameStep(serial: Simulation, other: Simulation, story: String) {
    assertEquals(stateDigest(serial.population), stateDigest(other.population)) { story }
    val a = serial.collisions!!
    val b = other.collisions!!
    fun counts(f: CollisionForcing) = with(f.counters) { listOf(collisions, wallCollisions, guardActivations) }
    assertEquals(counts(a), counts(b)) { story }
    val r = a.record!!
    val s = b.record!!
    assertEquals(r.size, s.size) { story }
    for (k in 0 until r.size) {
        val same = r.time[k] == s.time[k] &&
            r.rank[k] == s.rank[k] &&
            r.lower[k] == s.lower[k] &&
            r.higher[k] == s.higher[k] &&
            r.impulse(k) == s.impulse(k) &&
            (0..2).all { r.separation(k, it) == s.separation(k, it) }
        assertTrue(same) { "$story: collision $k differs" }
    }
}
