package daphnis.actors

import daphnis.actors.FaultKit.expected
import daphnis.actors.FaultKit.initial
import daphnis.actors.FaultKit.simulation
import daphnis.core.initial.SeededRandom
import daphnis.core.population.stateDigest
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.atomic.AtomicBoolean
import java.util.concurrent.locks.LockSupport

/** Interrupts of whoever waits or works, and threads that stay behind. The time limit is the watchdog. */
@Timeout(180, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
abstract class InterruptsContract(shares: Boolean) : BothWays(shares) {
    @Test
    fun `an interrupted host gets its step, and its interrupt`() {
        for (engine in engines()) {
            simulation(engine).use { simulation ->
                for (digest in expected) {
                    Thread.currentThread().interrupt()
                    simulation.advance()
                    assertTrue(Thread.interrupted())
                    assertEquals(digest, stateDigest(simulation.population))
                }
            }
        }
    }

    /** Runs [work] while a thread of its own does [disturb] again and again. */
    private fun disturbed(seed: Long, mostNanos: Int, disturb: () -> Unit, work: () -> Unit) {
        val isOver = AtomicBoolean()
        val random = SeededRandom(seed)
        val storm = Thread {
            while (!isOver.get()) {
                disturb()
                LockSupport.parkNanos(1L + random.nextInt(mostNanos))
            }
        }.apply { start() }
        try {
            work()
        } finally {
            isOver.set(true)
            while (storm.isAlive) runCatching { storm.join() }
            Thread.interrupted()
        }
    }

    @Tag("thorough")
    @Test
    fun `a storm of interrupts of the host, from its first step to its last`() {
        val host = Thread.currentThread()
        for (which in 0..1) {
            disturbed(1, 200_000, host::interrupt) {
                repeat(8) {
                    simulation(engines()[which]).use { simulation ->
                        for (digest in expected) {
                            simulation.advance()
                            assertEquals(digest, stateDigest(simulation.population))
                        }
                    }
                }
            }
        }
        FaultKit.awaitNoEngineThreads()
    }

    @Tag("thorough")
    @Test
    fun `one interrupt during the first step, while everything starts`() {
        val host = Thread.currentThread()
        val random = SeededRandom(2)
        for (which in 0..1) {
            repeat(25) {
                val nanos = 1L + random.nextInt(60_000_000)
                val other = Thread {
                    LockSupport.parkNanos(nanos)
                    host.interrupt()
                }.apply { start() }
                simulation(engines()[which]).use { simulation ->
                    simulation.advance()
                    while (other.isAlive) runCatching { other.join() }
                    Thread.interrupted()
                    assertEquals(expected[0], stateDigest(simulation.population))
                }
            }
        }
        FaultKit.awaitNoEngineThreads()
    }

    @Tag("thorough")
    @Test
    fun `a storm of interrupts of the threads on which regions run`() {
        val disturb = {
            val workers = FaultKit.engineThreads().filter { "-actors-" in it.name || "default-dispatcher" in it.name }
            workers.forEach { it.interrupt() }
        }
        for (engine in engines()) {
            engine.use {
                disturbed(3, 500_000, disturb) {
                    repeat(5) {
                        val simulation = simulation(engine)
                        for (digest in expected) {
                            simulation.advance()
                            assertEquals(digest, stateDigest(simulation.population))
                        }
                    }
                }
            }
        }
        FaultKit.awaitNoEngineThreads()
    }

    @Tag("thorough")
    @Test
    fun `engines that come and go, closed in order, in the middle of a step, or after a failure, leave no thread`() {
        for (which in 0..1) {
            repeat(10) { round ->
                var calls = 0
                lateinit var law: (Double) -> Double
                val engine = engines()[which]
                law = {
                    calls++
                    if (round % 3 == 1 && calls == 40) engine.close()
                    if (round % 3 == 2 && calls == 40) throw OutOfMemoryError("on purpose")
                    1.0
                }
                val simulation = simulation(engine) { law(it) }
                engine.loop.run(10_000) { _, _, _ -> }
                runCatching { repeat(2) { simulation.advance() } }
                simulation.close()
                runCatching { engine.loop.run(10_000) { _, _, _ -> } }
                runCatching { simulation.advance() }
            }
        }
        FaultKit.awaitNoEngineThreads()
    }

    @Test
    fun `twenty simulations at once, each with an engine of its own`() {
        val failures = java.util.concurrent.ConcurrentLinkedQueue<Throwable>()
        val threads = List(20) { k ->
            Thread {
                try {
                    val engine = if (k % 2 == 0) {
                        actors(3)
                    } else {
                        pekko(3)
                    }
                    simulation(engine).use { simulation ->
                        assertEquals(initial, stateDigest(simulation.population))
                        FaultKit.assertWorksOn(simulation) { engine.name }
                    }
                } catch (e: Throwable) {
                    failures += e
                }
            }.apply { start() }
        }
        threads.forEach { it.join() }
        failures.poll()?.let { throw it }
        FaultKit.awaitNoEngineThreads()
    }
}

class InterruptsTest : InterruptsContract(shares = false)

@Tag("thorough")
class SharedInterruptsTest : InterruptsContract(shares = true)
