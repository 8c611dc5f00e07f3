package daphnis.core.queue

import daphnis.core.initial.SeededRandom
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class EventQueueTest {
    private val queues = listOf(ReferenceEventQueue(), BucketEventQueue(), EventHeap())

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
    fun `every queue and the reference agree under random operations over many steps`() {
        for (seed in 1L..80L) {
            val random = SeededRandom(seed)
            val slots = 2 + random.nextInt(60)
            val ids = IntArray(slots) { slots - it }
            repeat(4) {
                val duration = doubleArrayOf(1.0, 1e-3, 1e-300, 1e300)[random.nextInt(4)]
                // A round to compare with: once in a while events all lie at one moment.
                val moments = intArrayOf(64, 64, 1)[random.nextInt(3)]
                for (queue in queues) queue.reset(duration, ids, slots)
                known.clear()
                repeat(random.nextInt(3000)) { add(draw(random, slots, 0.0, duration, moments)) }
                play(random, slots, duration, moments, "seed $seed")
            }
        }
    }

    private class Event(val time: Double, val first: Int, val second: Int, val image: Int)

    /** What was added since the reset, seen from the lower slot: a step finds each potential collision once. */
    private val known = HashSet<List<Any>>()

    /** Coarse times, so that ties are common; images likewise, of pairs that are named from either side. */
    private fun draw(random: SeededRandom, slots: Int, from: Double, to: Double, moments: Int): Event {
        val share = random.nextDouble()
        val time = to * if (random.nextInt(3) == 0) Math.rint(share * moments) / moments else share
        val a = random.nextInt(slots)
        val isWall = random.nextInt(20) == 0
        val b = if (isWall) -1 - random.nextInt(6) else (a + 1 + random.nextInt(slots - 1)) % slots
        val image = if (isWall) 0 else Images.code(random.nextInt(3) - 1, random.nextInt(3) - 1, 0)
        return Event(time.coerceIn(from, to), a, b, image)
    }

    private fun add(event: Event) {
        if (!known.add(seen(event.time, event.first, event.second, event.image))) return
        for (queue in queues) queue.add(event.time, event.first, event.second, event.image)
    }

    private fun play(random: SeededRandom, slots: Int, duration: Double, moments: Int, seed: String) {
        var popped = 0
        while (true) {
            val popping = queues.map { it.pop() }
            assertEquals(1, popping.toSet().size) { "$seed after $popped events" }
            if (!popping[0]) return
            popped++
            val seen = queues.map { seen(it.time, it.first, it.second, it.image) }
            assertEquals(1, seen.toSet().size) { "$seed after $popped events" }
            for (slot in listOf(queues[0].first, queues[0].second)) {
                // Not always: what was passed over is not to come back either.
                if (slot >= 0 && random.nextInt(3) > 0) for (queue in queues) queue.removeAllOf(slot)
            }
            if (random.nextInt(50) == 0) random.nextInt(slots).let { for (queue in queues) queue.removeAllOf(it) }
            if (popped > 2000) continue
            repeat(random.nextInt(4)) { add(draw(random, slots, queues[0].time, duration, moments)) }
        }
    }

    /** An event seen from the lower slot. */
    private fun seen(time: Double, first: Int, second: Int, image: Int): List<Any> {
        if (second in 0 until first) return listOf(time, second, first, Images.negated(image))
        return listOf(time, first, second, image)
    }

    @Test
    fun `ties between images of one pair are broken from the side of the lower id`() {
        for (queue in queues) {
            queue.reset(1.0, intArrayOf(7, 4), 2)
            // Seen from id 4 the image of the first is to the left, that of the second to the right, a lower code.
            queue.add(0.5, 1, 0, Images.code(-1, 0, 0))
            queue.add(0.5, 0, 1, Images.code(-1, 0, 0))
            assertTrue(queue.pop())
            assertEquals(0 to 1, queue.first to queue.second)
        }
    }

    @Test
    fun `slots that become known later are as good as those of the reset`() {
        val heap = EventHeap(1)
        for (round in 1..3) {
            heap.reset(1.0, IntArray(0), 0)
            val ids = IntArray(100) { 99 - it }
            for (slot in 0 until 100) {
                heap.include(slot, ids)
                if (slot > 0) heap.add(0.5, slot, slot - 1, 0)
            }
            heap.removeAllOf(50)
            val order = generateSequence { if (heap.pop()) heap.first else null }.toList()
            assertEquals((99 downTo 1).filter { it != 50 && it != 51 }, order) { "round $round" }
        }
    }

    @Test
    fun `the first slot that becomes known may be any`() {
        val heap = EventHeap(1)
        heap.reset(1.0, IntArray(0), 0)
        heap.include(7, IntArray(8) { it })
        heap.add(0.5, 7, -1, 0)
        assertTrue(heap.pop())
        assertEquals(7, heap.first)
    }

    @Test
    fun `a reset forgets what has not come out`() {
        for (queue in queues) {
            for (popped in 0..2) {
                queue.reset(1.0, IntArray(4) { it }, 4)
                for (k in 0..2) queue.add(0.25 * k, k, k + 1, 0)
                repeat(popped) { assertTrue(queue.pop()) }
                queue.reset(1.0, IntArray(4) { it }, 4)
                assertFalse(queue.pop()) { "$popped, ${queue.javaClass.simpleName}" }
            }
        }
    }
}
