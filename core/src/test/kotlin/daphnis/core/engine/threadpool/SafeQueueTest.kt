package daphnis.core.engine.threadpool

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.queue.EventStore
import daphnis.core.queue.ReferenceEventQueue
import daphnis.core.randomSpheres
import daphnis.core.step.StepLimits
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicIntegerArray

@Timeout(60)
class SafeQueueTest {
    private val n = 200
    private val boundary = Periodic(Box.centred(60.0, 60.0, 60.0))
    private val population = randomSpheres(n, boundary, 1, 0.5) { 0.5 }
    private val prepared = preparedOf(population, boundary)

    private fun newBusy() = BusyCells(prepared.rows, prepared.grid).apply { prepare(population) }

    private fun newQueue() =
        SafeQueue(newBusy(), StepLimits().apply { start(n, 0.0) }).apply { reset(1.0, prepared.rows.id, n) }

    private class Event(val time: Double, val first: Int, val second: Int)

    private fun drawEvent(random: SeededRandom, from: Double): Event {
        val first = random.nextInt(n)
        val second = if (random.nextInt(10) == 0) -1 - random.nextInt(6) else (first + 1 + random.nextInt(n - 1)) % n
        val time = if (random.nextInt(5) == 0) random.nextInt(9) / 8.0 else random.nextDouble()
        return Event(maxOf(from, time), first, second)
    }

    /**
     * The rule in its plainest form: pending collisions in order, of which the first is taken that is free beside all
     * that are being processed and all that were passed over.
     */
    private inner class Model {
        var pending = ArrayList<Event>()
        val working = ArrayList<Event>()

        /** Latest of those that were taken early. */
        var latestEarly = -1.0

        fun inOrder(): List<Event> {
            val queue = ReferenceEventQueue().apply { reset(1.0, prepared.rows.id, n) }
            for (e in pending) queue.add(e.time, e.first, e.second, 0)
            return generateSequence { if (queue.pop()) Event(queue.time, queue.first, queue.second) else null }.toList()
        }

        fun next(): Event? {
            val busy = newBusy()
            for (e in working) busy.add(e.first, e.second, e.time)
            for (e in inOrder().take(MOST_PASSED_OVER)) {
                if (busy.areFree(e.first, e.second, e.time)) {
                    isEarly = busy.hasBefore(e.time)
                    return e
                }
                busy.add(e.first, e.second, e.time)
            }
            return null
        }

        /** Whether what [next] has found comes after one that is busy. */
        var isEarly = false

        fun remove(event: Event) {
            pending.removeIf { listOf(it.time, it.first, it.second) == listOf(event.time, event.first, event.second) }
        }

        fun finish(done: Event, found: List<Event>) {
            working -= done
            val gone = setOf(done.first, done.second).filter { it >= 0 }
            pending = ArrayList(pending.filter { it.first !in gone && it.second !in gone } + found)
        }
    }

    private fun play(seed: Long): Int {
        val random = SeededRandom(seed)
        val queue = newQueue()
        val model = Model()
        val workers = Array(1 + random.nextInt(5)) { Taken() }
        val at = arrayOfNulls<Event>(workers.size)
        val start = EventStore()
        repeat(random.nextInt(150)) {
            val event = drawEvent(random, 0.0)
            model.pending += event
            start.add(event.time, event.first, event.second, 0)
        }
        queue.addAll(start)
        var together = 0
        var finished = 0
        while (!queue.isOver) {
            val worker = random.nextInt(workers.size)
            val event = at[worker]
            if (event == null) {
                val expected = model.next()
                val isTaken = queue.tryTake(workers[worker])
                assertEquals(expected != null, isTaken) { "seed $seed" }
                if (expected == null) continue
                val taken = workers[worker]
                assertEquals(
                    listOf(expected.time, expected.first, expected.second),
                    listOf(taken.time, taken.first, taken.second),
                )
                assertEquals(model.isEarly, taken.isEarly) { "seed $seed" }
                assertEquals(expected.time <= model.latestEarly, taken.isLate) { "seed $seed" }
                if (model.isEarly) model.latestEarly = maxOf(model.latestEarly, expected.time)
                model.remove(expected)
                model.working += expected
                at[worker] = expected
                together = maxOf(together, model.working.size)
            } else {
                val found = EventStore()
                val events = List(if (finished++ < 100) random.nextInt(3) else 0) { drawEvent(random, event.time) }
                for (e in events) found.add(e.time, e.first, e.second, 0)
                queue.finish(workers[worker], found)
                model.finish(event, events)
                at[worker] = null
            }
        }
        assertTrue(model.pending.isEmpty() && model.working.isEmpty()) { "seed $seed: over too early" }
        assertFalse(queue.take(Taken()))
        return together
    }

    @Test
    fun `what is handed out is the first that is safe, beside a plain model, in any order of workers`() {
        val together = (1L..120L).map(::play)
        assertTrue(together.max() >= 3) { "never more than ${together.max()} at a time" }
    }

    @Test
    fun `threads never hold two collisions that are near one another, and each collision is handed out once`() {
        val random = SeededRandom(7)
        repeat(30) { round ->
            val queue = newQueue()
            val start = EventStore()
            for (k in 0 until n / 2) start.add(random.nextDouble(), 2 * k, 2 * k + 1, 0)
            queue.addAll(start)
            val held = ConcurrentHashMap<Int, Event>()
            val handedOut = AtomicIntegerArray(n)
            val clashes = AtomicIntegerArray(1)
            FixedPool(4).use { pool ->
                pool.run {
                    val taken = Taken()
                    val found = EventStore()
                    while (queue.take(taken)) {
                        handedOut.incrementAndGet(taken.first)
                        val beside = newBusy()
                        held.values.forEach { beside.add(it.first, it.second, -1.0) }
                        if (!beside.areFree(taken.first, taken.second, taken.time)) clashes.incrementAndGet(0)
                        held[taken.first] = Event(taken.time, taken.first, taken.second)
                        Thread.yield()
                        held.remove(taken.first)
                        queue.finish(taken, found)
                    }
                }
            }
            assertEquals(0, clashes.get(0)) { "round $round" }
            for (k in 0 until n) assertEquals(if (k % 2 == 0) 1 else 0, handedOut.get(k)) { "round $round, slot $k" }
        }
    }

    @Test
    fun `a worker that waits is let go when another gives up`() {
        val queue = newQueue()
        queue.addAll(EventStore().apply { repeat(2) { add(0.5, 0, 1 + it, 0) } })
        FixedPool(2).use { pool ->
            pool.run {
                val taken = Taken()
                if (queue.take(taken)) {
                    // The other collision has a sphere in common with this one, which is never returned.
                    Thread.sleep(20)
                    queue.stop()
                }
            }
        }
        assertTrue(queue.isOver)
        assertFalse(queue.tryTake(Taken()))
    }

    @Test
    fun `more collisions than a step may have are refused`() {
        val queue = newQueue()
        val taken = Taken()
        val again = EventStore().apply { add(0.5, 0, 1, 0) }
        queue.addAll(again)
        for (k in 1L..StepLimits.mostCollisions(n)) {
            assertTrue(queue.tryTake(taken))
            queue.finish(taken, again)
        }
        assertThrows(IllegalArgumentException::class.java) { queue.tryTake(taken) }
    }

    private companion object {
        const val MOST_PASSED_OVER = 16
    }
}
