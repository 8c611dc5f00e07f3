package daphnis.actors

import daphnis.actors.FaultKit.initial
import daphnis.actors.region.Phase
import daphnis.actors.region.RegionCommand
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.population.stateDigest
import daphnis.core.step.CollisionStep
import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.CancellationException
import java.util.concurrent.CountDownLatch
import java.util.concurrent.atomic.AtomicInteger

/**
 * Engines closed and steps cancelled at every moment, from everywhere: the step happens wholly, or not at all and says
 * so. The time limit is the watchdog.
 */
@Timeout(120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
abstract class CloseContract(shares: Boolean) : BothWays(shares) {
    private fun assertWhole(step: CollisionStep, isDone: Boolean, about: () -> String) {
        assertEquals(
            if (isDone) stateDigest(FaultKit.done.population) else initial,
            stateDigest(step.population),
            about,
        )
        assertEquals(if (isDone) FaultKit.done.counters.collisions else 0, step.counters.collisions, about)
    }

    /**
     * One step of an engine that is closed meanwhile: all or nothing, and what it says is so.
     *
     * @return whether it was done
     */
    private fun assertWhole(engine: CollisionEngine, step: CollisionStep, about: String): Boolean {
        val thrown = runCatching { engine.advance(step) }.exceptionOrNull()
        assertTrue(thrown == null || thrown is CancellationException) { "$about: $thrown" }
        assertWhole(step, thrown == null) { "$about: $thrown" }
        return thrown == null
    }

    private fun assertRefuses(engine: CollisionEngine) {
        val step = FaultKit.step()
        val ways = listOf({ engine.advance(step) }, { engine.loop.run(10_000) { _, _, _ -> } })
        for (way in ways) {
            assertEquals("the engine is closed", assertThrows(IllegalStateException::class.java) { way() }.message)
        }
        assertEquals(initial, stateDigest(step.population))
    }

    @Tag("thorough")
    @Test
    fun `closed from another thread in every phase`() {
        for (phase in phases) {
            for (which in 0..1) {
                val inside = CountDownLatch(1)
                val closed = CountDownLatch(1)
                val engine = engines {
                    if (it.phase == phase) {
                        inside.countDown()
                        closed.await()
                    }
                }[which]
                val closer = Thread {
                    inside.await()
                    engine.close()
                    closed.countDown()
                }.apply { start() }
                val isDone = assertWhole(engine, FaultKit.step(), "$phase, ${engine.name}")
                assertTrue(!isDone) { "$phase, ${engine.name}: done, though a whole phase was to come" }
                closer.join()
                engine.close()
                assertRefuses(engine)
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `closed from within a function that a region calls, and from a thread that this waits for`() {
        val ways = listOf<(CollisionEngine) -> Unit>(
            { it.close() },
            { engine -> Thread { engine.close() }.apply { start() }.join() },
        )
        for (way in ways) {
            for (which in 0..1) {
                lateinit var engine: CollisionEngine
                engine = engines()[which]
                val law = { _: Double ->
                    way(engine)
                    1.0
                }
                assertWhole(engine, FaultKit.step(law), "in a law, ${engine.name}")
                assertRefuses(engine)
                for (phase in phases) {
                    engine = engines { if (it.phase == phase) way(engine) }[which]
                    assertWhole(engine, FaultKit.step(), "$phase, ${engine.name}")
                    assertRefuses(engine)
                }
            }
        }
    }

    @Test
    fun `closed in a step that the serial engine decides`() {
        for (which in 0..1) {
            val calls = AtomicInteger()
            val engine = engines()[which]
            val law = { _: Double ->
                val isJudge = Throwable().stackTrace.any { it.className == SerialEngine::class.java.name }
                if (isJudge) {
                    engine.close()
                } else if (calls.incrementAndGet() >= 30) {
                    error("on purpose")
                }
                1.0
            }
            val thread = Thread({ assertTrue(assertWhole(engine, FaultKit.step(law), engine.name)) }, "stepping")
            var failure: Throwable? = null
            thread.setUncaughtExceptionHandler { _, e -> failure = e }
            thread.start()
            thread.join()
            failure?.let { throw it }
            assertRefuses(engine)
        }
    }

    /** Whether the coordinator's last answer has come, after which there is only the end of the step. */
    private class LastCommand(private val phase: Phase) {
        private val commits = AtomicInteger()

        /** The number of commits that a whole step takes, for all regions and windows. */
        var total = Int.MAX_VALUE

        fun count(command: RegionCommand): Boolean = command.phase == phase && commits.incrementAndGet() == total

        fun reset(): Int = commits.getAndSet(0)
    }

    @Tag("thorough")
    @Test
    fun `closed at many moments around the end of a step`() {
        val host = FaultKit.actorSystem()
        for (which in 0..1) {
            val last = LastCommand(lastPhase)
            // How many commits a step takes belongs to the trajectory and the regions.
            engines { last.count(it) }[which].use { it.advance(FaultKit.step()) }
            last.total = last.reset()
            var done = 0
            val rounds = 120
            for (round in 0 until rounds) {
                val reached = CountDownLatch(1)
                val probe = { command: RegionCommand -> if (last.count(command)) reached.countDown() }
                // In a host's system, which is quicker than one for each.
                val engine = if (which == 0) {
                    engines(probe)[0]
                } else {
                    pekko(host = host).also { it.probe = probe }
                }
                val step = FaultKit.step()
                val closer = Thread {
                    reached.await()
                    // From at once to after the end.
                    val until = System.nanoTime() + round * 5_000L
                    while (System.nanoTime() < until) Thread.onSpinWait()
                    engine.close()
                }.apply { start() }
                if (assertWhole(engine, step, "round $round, ${engine.name}")) done++
                closer.join()
                assertRefuses(engine)
                last.reset()
            }
            assertTrue(done > 0) { "no step was done: the moments were too early" }
        }
        host.terminate()
    }

    @Tag("thorough")
    @Test
    fun `a coroutine cancelled at many moments around the end of a step`() {
        val last = LastCommand(lastPhase)
        val engine = actors()
        var reached = CompletableDeferred<Unit>()
        engine.probe = { if (last.count(it)) reached.complete(Unit) }
        runBlocking { engine.advanceSuspending(FaultKit.step()) }
        last.total = last.reset()
        var done = 0
        for (round in 0 until 200) {
            reached = CompletableDeferred()
            val step = FaultKit.step()
            var returned = false
            runBlocking(Dispatchers.Default) {
                val job: Job = launch {
                    engine.advanceSuspending(step)
                    returned = true
                }
                reached.await()
                val until = System.nanoTime() + round * 3_000L
                while (System.nanoTime() < until) Thread.onSpinWait()
                job.cancel()
                job.join()
            }
            last.reset()
            assertWhole(step, returned) { "round $round, returned: $returned" }
            if (returned) done++
        }
        assertTrue(done > 0) { "no step was done: the moments were too early" }
        engine.close()
    }

    @Test
    fun `a coroutine that is cancelled within a step leaves the population as before, and the engine works on`() {
        var slow = true
        val engine = actors().also { it.probe = { if (slow) Thread.sleep(5) } }
        val step = FaultKit.step()
        runBlocking {
            val job = launch { engine.advanceSuspending(step) }
            delay(30)
            job.cancel()
            job.join()
            assertTrue(job.isCancelled)
            assertEquals(initial, stateDigest(step.population))
            slow = false
            engine.advanceSuspending(step)
        }
        assertNotEquals(initial, stateDigest(step.population))
        engine.close()
    }

    @Test
    fun `a coroutine that was cancelled before begins no step`() {
        actors().use { engine ->
            val step = FaultKit.step()
            runBlocking {
                val job = launch {
                    coroutineContext[Job]!!.cancel()
                    engine.advanceSuspending(step)
                }
                job.join()
            }
            assertEquals(initial, stateDigest(step.population))
        }
    }

    @Test
    fun `closing twice, without a single step, and no thread or system started afterwards`() {
        FaultKit.awaitNoEngineThreads()
        for (engine in engines()) {
            engine.close()
            engine.close()
            assertRefuses(engine)
        }
        FaultKit.awaitNoEngineThreads()
    }
}

class CloseTest : CloseContract(shares = false)

@Tag("thorough")
class SharedCloseTest : CloseContract(shares = true)
