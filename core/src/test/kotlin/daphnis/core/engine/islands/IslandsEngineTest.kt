package daphnis.core.engine.islands

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.parallel.FixedPool
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import daphnis.core.step.CollapseException
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

@Timeout(60)
class IslandsEngineTest {
    @Test
    fun `an island that shoots a sphere into another one is noticed, dropped and merged`() {
        // Pairs {0 1} and {2 3} collide at t = 0.1; then 1, light and fast, hits 2 on the way that 2 has only got from
        // its own collision. 0 and 3 would miss.
        val spheres = arrayOf(
            Sphere(x = 0.0, vx = 10.0, r = 0.5),
            Sphere(x = 2.0, r = 0.5, m = 0.1),
            Sphere(x = 6.0, y = 2.5, r = 0.5),
            Sphere(x = 6.0, y = 4.5, vy = -10.0, r = 0.5),
        )
        val expected = populationOf(*spheres).also { simulationOf(it, Open, 1.0).advance() }
        for (threads in 1..4) {
            val p = populationOf(*spheres)
            val engine = IslandsEngine(FixedPool(threads), fewest = 0)
            val simulation = simulationOf(p, Open, 1.0, engine = engine)
            simulation.use { it.advance() }
            assertEquals(stateDigest(expected), stateDigest(p))
            assertTrue(simulation.collisions!!.counters.collisions > 2)
            assertTrue(engine.workers.redone > 0) { "no island was dropped: the case does not test what it should" }
        }
    }

    @Test
    fun `windows of any length give the same bits`() {
        // Dense enough that islands of whole steps grow into one another.
        val boundary = Periodic(Box.centred(14.0, 14.0, 14.0))
        val start = randomSpheres(700, boundary, 5, 1.0) { 0.8 }
        val slow = start.copy()
        val digests = simulationOf(slow, boundary, 0.5).use { List(2) { _ -> it.advance().let { stateDigest(slow) } } }
        // As shares of all spheres: a window per slice, some lengths between, the one that is learnt, one window.
        val lengths = listOf(0.0, 0.003, 0.02, 0.1, 0.4, null, 1000.0)
        val windows = lengths.map { share ->
            val p = start.copy()
            val engine = IslandsEngine(FixedPool(3), fewest = 0)
            if (share != null) engine.workers.window = WindowLength(share, share, leastSeeds = 0)
            simulationOf(p, boundary, 0.5, engine = engine).use {
                for (digest in digests) {
                    it.advance()
                    assertEquals(digest, stateDigest(p)) { "windows of $share of all spheres" }
                }
            }
            engine.workers.windows
        }
        // A step that is begun again counts its windows again.
        assertTrue(windows.first() >= 2 * Hints.SLICES && windows.last() in 2..10) { "windows were $windows" }
        assertEquals(windows.size, windows.toSet().size) { "windows were $windows: lengths did not vary" }
    }

    @Test
    fun `a collapse is thrown, the population is as before, and the engine can go on`() {
        val p = populationOf(*Array(40) { Sphere(x = 2.0001 * it, vx = (20 - it) * 1.0, r = 1.0) })
        val before = stateDigest(p)
        val engine = IslandsEngine(FixedPool(2), fewest = 0)
        val simulation = simulationOf(p, Open, 100.0, ConstantRestitution(0.2), engine = engine)
        assertThrows(CollapseException::class.java) { simulation.advance() }
        assertEquals(before, stateDigest(p))
        val q = populationOf(Sphere(x = -5.0, vx = 10.0), Sphere(x = 5.0, vx = -10.0))
        simulationOf(q, Open, 1.0, engine = engine).use { it.advance() }
        assertEquals(-7.0, q.x[q.indexOf(0)], 1e-14)
    }
}
