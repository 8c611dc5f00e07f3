package daphnis.core.engine

import daphnis.core.Simulation
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assertions.fail

/** Advances [simulation]; what was thrown, or null. */
fun failure(simulation: Simulation): String? = try {
    simulation.advance()
    null
} catch (e: RuntimeException) {
    "${e.javaClass.name}: ${e.message}"
}

/** Asserts that both have the same digest, numbers of every sphere, counts and record of collisions. */
fun assertSameStep(serial: Simulation, other: Simulation, story: String) {
    assertEquals(stateDigest(serial.population), stateDigest(other.population)) { story }
    assertSameColumns(serial.population, other.population, story)
    val a = serial.collisions!!
    val b = other.collisions!!
    fun counts(f: CollisionForcing) =
        with(f.counters) { listOf(collisions, wallCollisions, guardActivations, edgeEvents, mergers) }
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
            r.isEdge(k) == s.isEdge(k) &&
            (0..2).all { r.separation(k, it) == s.separation(k, it) }
        assertTrue(same) { "$story: collision $k differs" }
    }
}

/** Asserts that every column has the same bits for the same sphere, those outside the digest included. */
private fun assertSameColumns(one: Population, other: Population, story: String) {
    val here = one.indicesById()
    val there = other.indicesById()
    assertEquals(here.size, there.size) { story }
    for (place in 0 until one.columnCount) {
        val a = one.column(place)
        val b = other.column(place)
        assertEquals(a.isEmpty(), b.isEmpty()) { story }
        if (a.isEmpty()) continue
        val k = here.indices.find { a[here[it]].toRawBits() != b[there[it]].toRawBits() } ?: continue
        fail<Unit>("$story: column $place of sphere ${one.id[here[k]]} is ${b[there[k]]} for ${a[here[k]]}")
    }
}
