package daphnis.core.engine.threadpool

import daphnis.core.Sphere
import daphnis.core.boundary.Open
import daphnis.core.engine.SerialEngine
import daphnis.core.parallel.FixedPool
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.simulationOf
import daphnis.core.surface.Restitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.atomic.AtomicInteger

@Timeout(60)
class ThreadPoolEngineTest {
    /**
     * The first of the row is pushed at t = 0.5, the push runs through the row to its end at some 0.51; a stranger hits
     * the last of the row at 0.6.
     */
    private fun row() = populationOf(
        Sphere(x = -1.0, vx = 1.0, r = 0.25),
        *Array(30) { Sphere(x = 0.0001 + 0.5001 * it, r = 0.25) },
        Sphere(x = 0.5001 * 29, y = 6.5, vy = -10.0, r = 0.25),
    )

    @Test
    fun `a push that runs through a row to a collision already taken is noticed, and the step replayed`() {
        val expected = row().also { simulationOf(it, Open, 1.0).advance() }
        // Whoever processes the first push waits until the other worker has taken the stranger's collision.
        val calls = AtomicInteger()
        val strangerTaken = java.util.concurrent.CountDownLatch(1)
        val slow = Restitution { speed ->
            if (speed > 5) {
                strangerTaken.countDown()
            } else if (calls.getAndIncrement() == 0) {
                strangerTaken.await()
            }
            1.0
        }
        val p = row()
        val simulation = simulationOf(p, Open, 1.0, slow, engine = ThreadPoolEngine(2))
        simulation.use { it.advance() }
        assertEquals(stateDigest(expected), stateDigest(p))
        assertEquals(1L, simulation.collisions!!.counters.causalityReplays)
        assertTrue(simulation.collisions.counters.collisions >= 30)
    }

    @Test
    fun `a replay that fails is not counted, the one that succeeds is`() {
        var calls = AtomicInteger()
        var strangerTaken = java.util.concurrent.CountDownLatch(1)
        var isBroken = true
        val slow = Restitution { speed ->
            if (isBroken && Thread.currentThread().stackTrace.any { it.className == SerialEngine::class.java.name }) {
                throw ArithmeticException("on purpose")
            }
            if (speed > 5) {
                strangerTaken.countDown()
            } else if (calls.getAndIncrement() == 0) {
                strangerTaken.await()
            }
            1.0
        }
        val simulation = simulationOf(row(), Open, 1.0, slow, engine = ThreadPoolEngine(2))
        simulation.use {
            assertThrows(ArithmeticException::class.java) { it.advance() }
            assertEquals(0L, simulation.collisions!!.counters.causalityReplays)
            isBroken = false
            calls = AtomicInteger()
            strangerTaken = java.util.concurrent.CountDownLatch(1)
            it.advance()
        }
        assertEquals(1L, simulation.collisions!!.counters.causalityReplays)
    }

    @Test
    fun `what a law throws in an attempt is put before the serial engine`() {
        val expected = row().also { simulationOf(it, Open, 1.0).advance() }
        val picky = Restitution {
            if (Thread.currentThread().stackTrace.none {
                    it.className == SerialEngine::class.java.name
                }
            ) {
                throw ArithmeticException("on purpose")
            }
            1.0
        }
        val p = row()
        val simulation = simulationOf(p, Open, 1.0, picky, engine = ThreadPoolEngine(2))
        simulation.use { it.advance() }
        assertEquals(stateDigest(expected), stateDigest(p))
        assertEquals(1L, simulation.collisions!!.counters.causalityReplays)
        assertThrows(IllegalStateException::class.java, { simulation.advance() }, "a closed engine is not replaced")
    }

    @Test
    fun `one thread never has to replay, and gives the same`() {
        val expected = row().also { simulationOf(it, Open, 1.0).advance() }
        val p = row()
        val simulation = simulationOf(p, Open, 1.0, engine = ThreadPoolEngine(1))
        simulation.use { it.advance() }
        assertEquals(stateDigest(expected), stateDigest(p))
        assertEquals(0L, simulation.collisions!!.counters.causalityReplays)
    }

    @Test
    fun `a restitution that throws ends the step for all workers, and the population is as before`() {
        for (threads in 1..4) {
            val p = row()
            val before = stateDigest(p)
            simulationOf(p, Open, 1.0, {
                throw ArithmeticException("on purpose")
            }, engine = ThreadPoolEngine(threads)).use { simulation ->
                repeat(3) { assertThrows(ArithmeticException::class.java) { simulation.advance() } }
            }
            assertEquals(before, stateDigest(p))
        }
    }

    @Test
    fun `the spin lock excludes`() {
        val lock = SpinLock()
        var count = 0
        FixedPool(4).use { pool -> pool.run { repeat(50_000) { lock.use { count++ } } } }
        assertEquals(200_000, count)
    }

    @Test
    fun `many small steps on more threads than cores`() {
        val p = row()
        val q = row()
        simulationOf(p, Open, 0.01, engine = SerialEngine()).use { repeat(200) { _ -> it.advance() } }
        simulationOf(q, Open, 0.01, engine = ThreadPoolEngine(8)).use { repeat(200) { _ -> it.advance() } }
        assertEquals(stateDigest(p), stateDigest(q))
    }
}
