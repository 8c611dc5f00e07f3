package daphnis.core.parallel

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.Collections
import java.util.concurrent.Executors
import java.util.concurrent.atomic.AtomicBoolean
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicIntegerArray

@Timeout(60)
class ParallelTest {
    private fun handlers(threads: Int) = listOf(FixedPool(threads), ThreadPerTask(threads))

    @Tag("thorough")
    @Test
    fun `every worker runs once, also many times over`() {
        for (threads in 1..8) {
            for (handler in handlers(threads)) {
                handler.use {
                    val runs = AtomicIntegerArray(threads)
                    val times = if (handler is FixedPool) 3000 else 20
                    repeat(times) { _ -> it.run { worker -> runs.incrementAndGet(worker) } }
                    for (worker in 0 until threads) {
                        assertEquals(times, runs[worker]) {
                            "worker $worker of $threads, ${handler.javaClass.simpleName}"
                        }
                    }
                }
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `what workers write without any guard is seen after the run, and what the caller writes, by the workers`() {
        // A missed hand-over would show as a stale sum in one of many rounds.
        FixedPool(4).use { pool ->
            val cells = LongArray(4 * 16)
            var round = 0L
            repeat(20_000) {
                round++
                pool.run { worker -> cells[worker * 16] += round }
                val expected = round * (round + 1) / 2
                for (worker in 0..3) assertEquals(expected, cells[worker * 16])
            }
        }
    }

    @Test
    fun `every strategy covers every index once, for sizes around pieces and threads`() {
        for (threads in intArrayOf(1, 2, 3, 7)) {
            FixedPool(threads).use { pool ->
                for (strategy in LoopStrategy.entries) {
                    val loop = ParallelLoop(pool, strategy)
                    for (size in intArrayOf(0, 1, 2, 6, 7, 8, 63, 64, 65, 1000)) {
                        for (grain in intArrayOf(1, 3, 64, 2000)) {
                            val seen = AtomicIntegerArray(maxOf(size, 1))
                            loop.run(size, grain) { worker, from, to ->
                                assertTrue(worker in 0 until threads)
                                for (k in from until to) seen.incrementAndGet(k)
                            }
                            for (k in 0 until size) {
                                assertEquals(1, seen[k]) {
                                    "$strategy, $threads threads, size $size, grain $grain, index $k"
                                }
                            }
                        }
                    }
                }
            }
        }
    }

    @Test
    fun `the first failure is thrown when all have ended, and the handler works on`() {
        for (handler in handlers(4) +
            ExecutorHandler(Executors.newFixedThreadPool(4) { Thread(it).apply { isDaemon = true } }, 4)) {
            handler.use {
                val ended = AtomicIntegerArray(4)
                val e = assertThrows(IllegalStateException::class.java) {
                    handler.run { worker ->
                        try {
                            if (worker == 2) error("worker two")
                            Thread.sleep(20)
                        } finally {
                            ended.incrementAndGet(worker)
                        }
                    }
                }
                assertEquals("worker two", e.message)
                for (worker in 0..3) assertEquals(1, ended[worker])
                handler.run { worker -> ended.incrementAndGet(worker) }
                for (worker in 0..3) assertEquals(2, ended[worker])
            }
        }
    }

    @Test
    fun `an interrupt does not end the wait and is still set afterwards`() {
        for (handler in handlers(3)) {
            handler.use {
                val ended = AtomicIntegerArray(3)
                Thread.currentThread().interrupt()
                handler.run { worker ->
                    if (worker > 0) Thread.sleep(50)
                    ended.incrementAndGet(worker)
                }
                assertTrue(Thread.interrupted())
                for (worker in 0..2) assertEquals(1, ended[worker])
            }
        }
    }

    @Test
    fun `closing twice is allowed, running afterwards is refused`() {
        for (handler in handlers(1) + handlers(3)) {
            handler.run { }
            handler.close()
            handler.close()
            assertThrows(IllegalStateException::class.java) { handler.run { } }
        }
        assertThrows(IllegalArgumentException::class.java) { FixedPool(0) }
        assertThrows(IllegalArgumentException::class.java) { ThreadPerTask(257) }
    }

    @Test
    fun `closing from another thread while tasks run neither hangs nor loses a task`() {
        repeat(200) {
            val pool = FixedPool(3)
            val count = AtomicIntegerArray(3)
            var runs = 0
            val closer = Thread { pool.close() }
            try {
                repeat(1000) { k ->
                    if (k == 3) closer.start()
                    pool.run { worker -> count.incrementAndGet(worker) }
                    runs++
                }
            } catch (e: IllegalStateException) {
                // Closed in between.
            }
            closer.join()
            for (worker in 0..2) assertEquals(runs, count[worker])
        }
    }

    @Test
    fun `a light loop runs on the caller's thread up to a size, and in pieces from there on`() {
        FixedPool(2).use { pool ->
            val loop = ParallelLoop(pool, LoopStrategy.DYNAMIC)
            for ((size, count) in listOf(0 to 0, 1 to 1, 8192 to 1, 8193 to 5)) {
                val pieces = AtomicInteger()
                val seen = AtomicIntegerArray(size)
                val isOwn = AtomicBoolean(true)
                val caller = Thread.currentThread()
                loop.runLight(size) { _, from, to ->
                    pieces.incrementAndGet()
                    if (Thread.currentThread() !== caller) isOwn.set(false)
                    for (k in from until to) seen.incrementAndGet(k)
                }
                assertEquals(count, pieces.get()) { "$size" }
                assertTrue((0 until size).all { seen[it] == 1 })
                assertTrue(size > 8192 || isOwn.get())
            }
        }
    }

    @Test
    fun `a loop without its workers runs on the caller's thread in one piece, and for others only where it is light`() {
        FixedPool(2).use { pool ->
            val whole = ParallelLoop(pool, LoopStrategy.DYNAMIC)
            val gate = ClosableLoop(whole, "closed")
            val loop = OptionalLoop(gate)
            fun pieces(run: (RangeBody) -> Unit): List<Int> {
                val pieces = Collections.synchronizedList(ArrayList<Int>())
                run { _, from, to -> pieces.add(to - from) }
                return pieces.sorted()
            }
            val shared = listOf(1808, 2048, 2048, 2048, 2048)
            val size = shared.sum()
            for (isAlone in listOf(false, true, false)) {
                loop.isAlone = isAlone
                val own = if (isAlone) listOf(size) else shared
                assertEquals(if (isAlone) 1 else 2, loop.active)
                assertEquals(2, loop.workers)
                assertEquals(own, pieces { loop.run(size, it) })
                assertEquals(own, pieces { loop.run(size, 2048, it) })
                assertEquals(own, pieces { loop.runLight(size, it) })
                assertEquals(shared, pieces { loop.forOthers.run(size, it) })
                assertEquals(shared, pieces { loop.forOthers.run(size, 2048, it) })
                assertEquals(own, pieces { loop.forOthers.runLight(size, it) })
                assertEquals(own, pieces { ClosableLoop(loop.forOthers, "closed").runLight(size, it) })
                assertEquals(emptyList<Int>(), pieces { loop.run(0, it) })
            }
            gate.close()
            for (isAlone in listOf(false, true)) {
                loop.isAlone = isAlone
                assertThrows(IllegalStateException::class.java) { loop.run(9) { _, _, _ -> } }
                assertThrows(IllegalStateException::class.java) { loop.runLight(9) { _, _, _ -> } }
                assertThrows(IllegalStateException::class.java) { loop.forOthers.runLight(9) { _, _, _ -> } }
            }
        }
    }

    @Test
    fun `extremes of an array, found in parallel`() {
        FixedPool(3).use { pool ->
            val loop = ParallelLoop(pool, LoopStrategy.DYNAMIC)
            val a = DoubleArray(100_000) { ((it * 7919L) % 100_003).toDouble() - 60_000 }
            val extremes = Extremes().measure(a, a.size, loop)
            assertEquals(a.min(), extremes.least)
            assertEquals(a.max(), extremes.greatest)
            assertEquals(maxOf(-a.min(), a.max()), extremes.magnitude)
            assertEquals(0.0, Extremes().measure(a, 0, loop).magnitude)
            a[77_777] = Double.NaN
            assertEquals(a.filterNot { it.isNaN() }.max(), Extremes().measure(a, a.size, loop).greatest)
        }
    }
}
