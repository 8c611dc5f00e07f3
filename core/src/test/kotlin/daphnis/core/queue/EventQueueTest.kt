package daphnis.core.queue

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class EventQueueTest {
    private val queues = listOf(ReferenceEventQueue(), BucketEventQueue())

    @Test
    fun `events come out by time, then lower id, then higher id`() {
        for (queue in queues) {
            queue.reset(1.0, intArrayOf(3, 1, 2, 0), 4)
            queue.add(0.5, 0, 1, 0) // ids 1, 3
            queue.add(0.5, 2, 1, 0) // ids 1, 2
            queue.add(0.5, 3, 0, 0) // ids 0, 3
            queue.add(0.25, 0, 2, 0) // earlier
            queue.add(0.5, 1, -1, 0) // a wall counts as a negative id
            val order = buildList { while (queue.pop()) add(queue.first to queue.second) }
            assertEquals(listOf(0 to 2, 1 to -1, 3 to 0, 2 to 1, 0 to 1), order)
        }
    }

    @Test
    fun `what a sphere had queued is gone, what it queues later stays`() {
        for (queue in queues) {
            queue.reset(1.0, IntArray(4) { it }, 4)
            queue.add(0.1, 0, 1, 0)
            queue.add(0.2, 2, 3, 0)
            queue.add(0.3, 1, 2, 0)
            queue.removeAllOf(1)
            queue.add(0.4, 1, 3, 0)
            assertTrue(queue.pop())
            assertEquals(0.2, queue.time)
            assertTrue(queue.pop())
            assertEquals(0.4, queue.time)
            assertFalse(queue.pop())
        }
    }

    @Test
    fun `an event may lie at either end of the step`() {
        for (queue in queues) {
            queue.reset(0.3, IntArray(2) { it }, 2)
            queue.add(0.3, 0, 1, 0)
            queue.add(0.0, 0, 1, 1)
            assertTrue(queue.pop())
            assertEquals(0.0, queue.time)
            assertTrue(queue.pop())
            assertEquals(0.3, queue.time)
            assertFalse(queue.pop())
            assertFalse(queue.pop())
        }
    }

    @Test
    fun `the fast queue and the reference agree under random operations over many steps`() {
        val (slow, fast) = queues
        for (seed in 1L..60L) {
            val random = SeededRandom(seed)
            val slots = 2 + random.nextInt(60)
            val ids = IntArray(slots) { slots - it }
            repeat(4) {
                val duration = if (random.nextInt(2) == 0) 1.0 else 1e-3
                for (queue in queues) queue.reset(duration, ids, slots)
                repeat(random.nextInt(3000)) { add(slow, fast, slots, random.nextDouble() * duration, random) }
                play(slow, fast, slots, duration, random, seed)
            }
        }
    }

    /** Coarse times, so that ties are common. */
    private fun add(slow: EventQueue, fast: EventQueue, slots: Int, time: Double, random: SeededRandom) {
        val t = if (random.nextInt(3) == 0) Math.rint(time * 64) / 64 else time
        val a = random.nextInt(slots)
        val b = if (random.nextInt(20) == 0) -1 - random.nextInt(6) else (a + 1 + random.nextInt(slots - 1)) % slots
        val image = if (b < 0) 0 else random.nextInt(3)
        slow.add(t, a, b, image)
        fast.add(t, a, b, image)
    }

    private fun play(
        slow: EventQueue,
        fast: EventQueue,
        slots: Int,
        duration: Double,
        random: SeededRandom,
        seed: Long,
    ) {
        var popped = 0
        while (true) {
            val more = slow.pop()
            assertEquals(more, fast.pop()) { "seed $seed after $popped events" }
            if (!more) return
            popped++
            assertEquals(slow.time, fast.time) { "seed $seed after $popped events" }
            assertEquals(setOf(slow.first, slow.second), setOf(fast.first, fast.second)) {
                "seed $seed after $popped events"
            }
            for (slot in listOf(slow.first, slow.second)) {
                if (slot < 0) continue
                slow.removeAllOf(slot)
                fast.removeAllOf(slot)
            }
            val rest = duration - slow.time
            val now = slow.time
            if (popped < 2000) {
                repeat(random.nextInt(4)) {
                    add(
                        slow,
                        fast,
                        slots,
                        minOf(
                            duration,
                            now + random.nextDouble() * rest,
                        ),
                        random,
                        now,
                    )
                }
            }
        }
    }

    private fun add(slow: EventQueue, fast: EventQueue, slots: Int, time: Double, random: SeededRandom, now: Double) {
        val a = random.nextInt(slots)
        val b = (a + 1 + random.nextInt(slots - 1)) % slots
        val t = maxOf(time, now)
        slow.add(t, a, b, 0)
        fast.add(t, a, b, 0)
    }
}
