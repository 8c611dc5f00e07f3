package daphnis.actors

import daphnis.actors.FaultKit.actorSystem
import daphnis.actors.FaultKit.expected
import daphnis.actors.FaultKit.initial
import daphnis.actors.FaultKit.simulation
import daphnis.core.population.stateDigest
import kotlinx.coroutines.CoroutineDispatcher
import kotlinx.coroutines.Runnable
import kotlinx.coroutines.asCoroutineDispatcher
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.CountDownLatch
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.atomic.AtomicInteger
import kotlin.coroutines.CoroutineContext

/**
 * What regions run on ends, or takes their work and does nothing: the step ends with a line that says so. The time
 * limit is the watchdog.
 */
@Timeout(120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
abstract class HostEndsContract(shares: Boolean) : BothWays(shares) {
    private fun executor(): ExecutorService = Executors.newFixedThreadPool(2) { Thread(it).apply { isDaemon = true } }

    private val ways = listOf<(ExecutorService) -> Unit>({ it.shutdown() }, { it.shutdownNow() })

    @Test
    fun `an actor system that has ended before the first step, and between two`() {
        for (stepsBefore in 0..1) {
            val host = actorSystem()
            simulation(pekko(host = host)).use { simulation ->
                repeat(stepsBefore) { simulation.advance() }
                host.terminate()
                host.getWhenTerminated().toCompletableFuture().get()
                repeat(2) {
                    val e = assertThrows(IllegalStateException::class.java) { simulation.advance() }
                    assertTrue("the actor system \"host\"" in e.message!!) { e.message }
                }
                assertEquals(if (stepsBefore == 0) initial else expected[0], stateDigest(simulation.population))
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `an actor system that ends in the middle of a step`() {
        for (moment in intArrayOf(1, 3, 30, 100)) {
            val host = actorSystem()
            val calls = AtomicInteger()
            val law = { _: Double ->
                if (calls.incrementAndGet() == moment) {
                    host.terminate()
                    Thread.sleep(300)
                }
                1.0
            }
            simulation(pekko(host = host), law).use { simulation ->
                val e = assertThrows(IllegalStateException::class.java) { simulation.advance() }
                assertTrue("the actor system \"host\"" in e.message!!) { e.message }
                assertEquals(initial, stateDigest(simulation.population))
                assertThrows(IllegalStateException::class.java) { simulation.advance() }
            }
        }
    }

    @Test
    fun `an executor behind the dispatcher that is shut down before the first step, and between two`() {
        for (end in ways) {
            for (stepsBefore in 0..1) {
                val executor = executor()
                simulation(actors(dispatcher = executor.asCoroutineDispatcher())).use { simulation ->
                    repeat(stepsBefore) { simulation.advance() }
                    end(executor)
                    repeat(2) {
                        val e = assertThrows(IllegalStateException::class.java) { simulation.advance() }
                        assertTrue("the dispatcher" in e.message!!) { e.message }
                    }
                    assertEquals(if (stepsBefore == 0) initial else expected[0], stateDigest(simulation.population))
                }
            }
        }
    }

    @Test
    fun `an executor behind the dispatcher that is shut down in the middle of a step`() {
        for (end in ways) {
            for (moment in intArrayOf(1, 3, 30, 100)) {
                val executor = executor()
                val calls = AtomicInteger()
                val law = { _: Double ->
                    if (calls.incrementAndGet() == moment) end(executor)
                    1.0
                }
                simulation(actors(dispatcher = executor.asCoroutineDispatcher()), law).use { simulation ->
                    val e = assertThrows(IllegalStateException::class.java) { simulation.advance() }
                    assertTrue("the dispatcher" in e.message!!) { e.message }
                    assertEquals(initial, stateDigest(simulation.population))
                }
            }
        }
    }

    /** Drops what it is given once [dead] is set. */
    private class Forgetful(private val executor: ExecutorService) : CoroutineDispatcher() {
        @Volatile
        var dead = false

        override fun dispatch(context: CoroutineContext, block: Runnable) {
            if (!dead) executor.execute(block)
        }
    }

    @Test
    fun `a dispatcher that takes the regions' work and never does it`() {
        val executor = executor()
        val dispatcher = Forgetful(executor)
        val engine = actors(dispatcher = dispatcher).also { it.patience = 300_000_000 }
        simulation(engine).use { simulation ->
            simulation.advance()
            dispatcher.dead = true
            val e = assertThrows(IllegalStateException::class.java) { simulation.advance() }
            assertTrue("no region has begun its work for 0.3 s: the threads of the dispatcher" in e.message!!) {
                e.message
            }
            val step = FaultKit.step()
            assertThrows(IllegalStateException::class.java) { runBlocking { engine.advanceSuspending(step) } }
            assertEquals(initial, stateDigest(step.population))
            dispatcher.dead = false
            simulation.advance()
            assertEquals(expected[1], stateDigest(simulation.population))
        }
        executor.shutdown()
    }

    @Test
    fun `an actor system whose threads are all busy with something else, until they are not`() {
        val host = actorSystem()
        val free = CountDownLatch(1)
        val dispatcher = host.executionContext()
        val engine = pekko(host = host).also { it.patience = 300_000_000 }
        simulation(engine).use { simulation ->
            simulation.advance()
            // More than it can have threads, none of which says that it blocks.
            repeat(512) { dispatcher.execute { free.await() } }
            val e = assertThrows(IllegalStateException::class.java) { simulation.advance() }
            assertTrue(
                "no region has begun its work for 0.3 s: the threads of the actor system \"host\"" in e.message!!,
            ) {
                e.message
            }
            assertEquals(expected[0], stateDigest(simulation.population))
            free.countDown()
            simulation.advance()
            assertEquals(expected[1], stateDigest(simulation.population))
        }
        host.terminate()
    }

    @Test
    fun `inside a host with an actor system of its own, engines come and go and the system stays`() {
        val host = actorSystem()
        try {
            repeat(5) {
                pekko(host = host).use { engine ->
                    val simulation = simulation(engine)
                    simulation.advance()
                    assertEquals(expected[0], stateDigest(simulation.population))
                }
                assertFalse(host.whenTerminated().isCompleted)
            }
        } finally {
            host.terminate()
        }
    }
}

class HostEndsTest : HostEndsContract(shares = false)

@Tag("thorough")
class SharedHostEndsTest : HostEndsContract(shares = true)
