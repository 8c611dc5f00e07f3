package daphnis.actors

import daphnis.actors.FaultKit.assertWorksOn
import daphnis.actors.FaultKit.initial
import daphnis.actors.FaultKit.serialEngines
import daphnis.actors.FaultKit.simulation
import daphnis.actors.coroutine.RegionActorEngine
import daphnis.core.population.stateDigest
import kotlinx.coroutines.cancel
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.CancellationException

/** Steps that are not shared: the serial engine takes them, on the thread of the coordinator. */
@Timeout(120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class SerialStepsTest {
    @Test
    fun `no region is told, all is done on one thread, and nothing is a replay`() {
        val told = ArrayList<Int>()
        val threads = HashSet<Thread>()
        for (engine in serialEngines { told += it }) {
            val law = { _: Double ->
                threads += Thread.currentThread()
                1.0
            }
            simulation(engine, law).use { simulation ->
                assertWorksOn(simulation) { engine.name }
                assertEquals(0, simulation.collisions!!.counters.causalityReplays)
            }
        }
        assertEquals(emptyList<Int>(), told)
        assertEquals(setOf(Thread.currentThread()), threads)
    }

    @Test
    fun `what a law throws comes out of the step as it is, and the engine works on`() {
        for (thrown in listOf(IllegalStateException("on purpose"), CancellationException("on purpose"), Error("so"))) {
            for (engine in serialEngines()) {
                var calls = 0
                val law = { _: Double -> if (++calls == 10) throwAny(thrown) else 1.0 }
                simulation(engine, law).use { simulation ->
                    assertSame(thrown, runCatching { simulation.advance() }.exceptionOrNull()) { engine.name }
                    assertEquals(initial, stateDigest(simulation.population))
                    assertWorksOn(simulation) { engine.name }
                }
            }
        }
    }

    @Test
    fun `closed at any collision, the step ends before the next and leaves the population as before`() {
        for (last in intArrayOf(1, 10, FaultKit.done.counters.collisions.toInt())) {
            for (engine in serialEngines()) {
                var calls = 0
                val step = FaultKit.step { if (++calls == last) engine.close().let { 1.0 } else 1.0 }
                val e = assertThrows(CancellationException::class.java) { engine.advance(step) }
                assertEquals("the engine is closed", e.message)
                assertEquals(last, calls)
                assertEquals(initial, stateDigest(step.population))
                assertEquals(0, step.counters.collisions)
            }
        }
    }

    @Test
    fun `a coroutine cancelled at a collision leaves the population as before, and the engine works on`() {
        val engine = serialEngines()[0] as RegionActorEngine
        engine.use {
            var isDone = false
            runBlocking {
                launch {
                    val step = FaultKit.step { cancel().let { 1.0 } }
                    try {
                        engine.advanceSuspending(step)
                        isDone = true
                    } finally {
                        assertEquals(initial, stateDigest(step.population))
                    }
                }
            }
            assertTrue(!isDone)
            val step = FaultKit.step()
            engine.advance(step)
            assertEquals(stateDigest(FaultKit.done.population), stateDigest(step.population))
        }
    }

    @Test
    fun `an interrupted host gets its step, and its interrupt`() {
        for (engine in serialEngines()) {
            engine.use {
                val step = FaultKit.step()
                Thread.currentThread().interrupt()
                engine.advance(step)
                assertTrue(Thread.interrupted())
                assertEquals(stateDigest(FaultKit.done.population), stateDigest(step.population))
            }
        }
    }
}
