package daphnis.core.parallel

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.engine.threadpool.ThreadPoolEngine
import daphnis.core.population.stateDigest
import daphnis.core.randomSpheres
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.CountDownLatch
import java.util.concurrent.Executor
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicIntegerArray

/**
 * Threads that cannot be had, die, are interrupted or busy: every part of a task is done once, and nobody waits for
 * ever. The time limit is the watchdog.
 */
@Timeout(60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class HandlersInTroubleTest {
    private fun pool(threads: Int): ExecutorService = Executors.newFixedThreadPool(threads) {
        Thread(it).apply {
            isDaemon =
                true
        }
    }

    private fun assertEachOnce(handler: ThreadHandler, about: String = "") {
        val runs = AtomicIntegerArray(handler.threads)
        handler.run { runs.incrementAndGet(it) }
        for (worker in 0 until handler.threads) assertEquals(1, runs[worker]) { "worker $worker, $about" }
    }

    @Test
    fun `an executor that rejects the n-th task`() {
        for (n in 1..6) {
            for (error in listOf(
                RejectedExecutionException(),
                IllegalStateException(),
                OutOfMemoryError("unable to create native thread"),
            )) {
                val threads = pool(2)
                val tasks = AtomicInteger()
                val executor = Executor { if (tasks.incrementAndGet() == n) throw error else threads.execute(it) }
                val handler = ExecutorHandler(executor, 4)
                repeat(3) { assertEachOnce(handler, "the $n-th rejected") }
                threads.shutdown()
            }
        }
    }

    @Test
    fun `an executor that was shut down, drops tasks, runs them twice or has only the caller's thread`() {
        val down = pool(2).apply { shutdown() }
        assertEachOnce(ExecutorHandler(down, 4))
        assertEachOnce(ExecutorHandler({ }, 4))
        assertEachOnce(
            ExecutorHandler(
                {
                    it.run()
                    it.run()
                },
                4,
            ),
        )
        val single = pool(1)
        single.submit { assertEachOnce(ExecutorHandler(single, 4)) }.get()
        single.shutdown()
    }

    @Test
    fun `an executor that begins its tasks when all is over finds nothing to do`() {
        val late = ArrayList<Runnable>()
        val runs = AtomicInteger()
        val handler = ExecutorHandler({ late += it }, 5)
        handler.run { runs.incrementAndGet() }
        late.forEach { it.run() }
        assertEquals(5, runs.get())
    }

    @Test
    fun `an executor that is shut down in the middle of a task`() {
        repeat(50) {
            val threads = pool(2)
            val handler = ExecutorHandler(threads, 3)
            val runs = AtomicInteger()
            handler.run { worker ->
                if (worker == it % 3) threads.shutdownNow()
                runs.incrementAndGet()
            }
            assertEquals(3, runs.get())
        }
    }

    private fun step(): CollisionStep {
        val boundary = Periodic(Box.centred(28.0, 28.0, 28.0))
        val p = randomSpheres(5000, boundary, 5, 1.0) { 0.5 }
        return CollisionStep(p, boundary, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters()).also {
            it.duration =
                0.1
        }
    }

    @Test
    fun `parallel engines take the step on an executor that rejects the n-th task, or all from then on`() {
        val expected = step().also { SerialEngine().advance(it) }.let { stateDigest(it.population) }
        val engines: List<(ThreadHandler) -> CollisionEngine> =
            listOf({ IslandsEngine(it, fewest = 0) }, { ThreadPoolEngine(it) })
        for (engine in engines) {
            for (isLasting in listOf(false, true)) {
                var n = 1
                while (true) {
                    val threads = pool(2)
                    val tasks = AtomicInteger()
                    val executor = Executor {
                        val k = tasks.incrementAndGet()
                        if (k == n || isLasting && k > n) throw RejectedExecutionException() else threads.execute(it)
                    }
                    val step = step()
                    engine(ExecutorHandler(executor, 3)).use { it.advance(step) }
                    assertEquals(expected, stateDigest(step.population)) { "the $n-th rejected" }
                    threads.shutdown()
                    if (tasks.get() < n) break
                    n += 1 + n / 8
                }
                assertTrue(n > 10) { "only $n tasks" }
            }
        }
    }

    @Test
    fun `when no more threads can be started, the caller does the work of those that are missing`() {
        for (n in 1..4) {
            fun startUpTo(): (Thread) -> Unit {
                val starts = AtomicInteger()
                return {
                    if (starts.incrementAndGet() >= n) {
                        throw OutOfMemoryError("unable to create native thread")
                    } else {
                        it.start()
                    }
                }
            }
            FixedPool(5, startUpTo()).use { pool -> repeat(100) { assertEachOnce(pool, "FixedPool, $n") } }
            ThreadPerTask(5, startUpTo()).use { handler -> repeat(3) { assertEachOnce(handler, "ThreadPerTask, $n") } }
        }
    }

    @Test
    fun `an interrupted worker of the fixed pool sleeps when it has nothing to do`() {
        val workers = arrayOfNulls<Thread>(3)
        FixedPool(3).use { pool ->
            pool.run { worker -> workers[worker] = Thread.currentThread() }
            repeat(3) {
                // Once while it sleeps, and once while it works.
                for (worker in 1..2) workers[worker]!!.interrupt()
                pool.run { worker -> if (worker > 0) Thread.currentThread().interrupt() }
                for (worker in 1..2) awaitAsleep(workers[worker]!!)
            }
            assertEachOnce(pool)
        }
    }

    /** A thread that spins on an interrupt that it does not clear never gets to sleep. */
    private fun awaitAsleep(thread: Thread) {
        var asleep = 0
        while (asleep < 100) {
            if (thread.state == Thread.State.WAITING) asleep++ else asleep = 0
            Thread.sleep(0, 100_000)
        }
    }

    @Test
    fun `workers that are interrupted again and again lose no task`() {
        FixedPool(3).use { pool ->
            val workers = arrayOfNulls<Thread>(3)
            pool.run { worker -> workers[worker] = Thread.currentThread() }
            val isOver = CountDownLatch(1)
            val storm = Thread { while (isOver.count > 0) workers.forEach { it!!.interrupt() } }.apply { start() }
            repeat(2000) { assertEachOnce(pool) }
            isOver.countDown()
            while (storm.isAlive) runCatching { storm.join() }
            Thread.interrupted()
        }
    }

    @Test
    fun `whatever workers throw, all of them and the same, the handler says so and works on`() {
        val error = StackOverflowError("on purpose")
        val threads = pool(4)
        for (handler in listOf(FixedPool(4), ThreadPerTask(4), ExecutorHandler(threads, 4))) {
            handler.use {
                repeat(20) {
                    assertSame(error, assertThrows(StackOverflowError::class.java) { handler.run { throw error } })
                }
                assertEachOnce(handler)
            }
        }
        threads.shutdown()
    }
}
