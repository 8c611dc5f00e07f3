package daphnis.core.engine.islands

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.ConstantRestitution
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import daphnis.core.step.CollapseException
import daphnis.core.step.CollisionStep
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
            assertTrue(engine.crew.redone > 0) { "no island was dropped: the case does not test what it should" }
        }
    }

    @Test
    fun `windows of any length give the same bits`() {
        // Dense enough that islands of whole steps would grow into one another: many windows and merges.
        val boundary = Periodic(Box.centred(14.0, 14.0, 14.0))
        val p = randomSpheres(700, boundary, 5, 1.0) { 0.8 }
        val q = p.copy()
        val engine = IslandsEngine(FixedPool(3), fewest = 0)
        val fast = simulationOf(p, boundary, 0.5, engine = engine)
        val slow = simulationOf(q, boundary, 0.5)
        fast.use {
            repeat(6) { _ ->
                it.advance()
                slow.advance()
                assertEquals(stateDigest(q), stateDigest(p))
            }
        }
        assertTrue(engine.crew.windows > 20) { "only ${engine.crew.windows} windows" }
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

    private fun stepOf(p: Population) =
        CollisionStep(p, Open, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters()).also {
            it.duration =
                1.0
        }

    @Test
    fun `of many claims on one sphere one succeeds, whoever is quicker`() {
        val p = populationOf(*Array(64) { Sphere(x = 3.0 * it) })
        val field = IslandField(4)
        val step = stepOf(p)
        FixedPool(4).use { pool ->
            repeat(300) {
                field.measure(step)
                field.prepare(step)
                val won = Array(4) { IntArray(64) }
                pool.run { worker -> for (slot in 0 until 64) if (field.claim(slot, worker)) won[worker][slot] = 1 }
                for (slot in 0 until 64) assertEquals(1, won.sumOf { it[slot] })
                for (slot in 0 until 64) field.release(slot)
            }
        }
    }

    @Test
    fun `unions from all threads at once join what they should and nothing else`() {
        val n = 1000
        val p = populationOf(*Array(n) { Sphere(x = 3.0 * it) })
        val field = IslandField(4)
        val step = stepOf(p)
        FixedPool(4).use { pool ->
            repeat(100) { round ->
                field.measure(step)
                field.prepare(step)
                // Classes modulo 7, joined link by link by four workers in different orders.
                pool.run { worker ->
                    for (k in 0 until n - 7) {
                        val slot = (k * 37 + worker * 251 + round) % (n - 7)
                        field.union(slot, slot + 7)
                    }
                }
                for (slot in 0 until n) assertEquals(slot % 7, field.find(slot))
                for (slot in 0 until n) field.release(slot)
            }
        }
    }
}
