package daphnis.core.queue

import daphnis.core.initial.SeededRandom
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What mutants of the queue got away with: images of a pair, and a store that is squeezed while half of it is dead. */
class CrowdedQueueTest {
    private fun queues() = listOf(ReferenceEventQueue(), BucketEventQueue())

    private class Event(val time: Double, val first: Int, val second: Int, val image: Int) {
        override fun toString() = "$first with image $image of $second at $time"
    }

    private fun EventQueue.add(e: Event) = add(e.time, e.first, e.second, e.image)

    @Test
    fun `images of a pair at one time come in their order as seen from the lower id, whichever sphere asked`() {
        val ids = intArrayOf(5, 3)
        val events = buildList {
            for (x in listOf(-1, 1, 2)) {
                // As slot 1, which has the lower id, sees them: x boxes away, and one up.
                add(Event(0.5, 1, 0, Images.code(x, 0, 0)))
                add(Event(0.5, 0, 1, Images.negated(Images.code(x, 0, 1))))
            }
        }
        val fromLower = { e: Event -> if (e.first == 1) e.image else Images.negated(e.image) }
        val expected = events.sortedBy(fromLower).map { "$it" }
        val random = SeededRandom(1)
        repeat(50) { round ->
            val shuffled = events.toMutableList()
            for (k in shuffled.size - 1 downTo 1) shuffled[k] = shuffled.set(random.nextInt(k + 1), shuffled[k])
            for (queue in queues()) {
                queue.reset(1.0, ids, 2)
                for (e in shuffled) queue.add(e)
                val order = buildList {
                    while (queue.pop()) add("${Event(queue.time, queue.first, queue.second, queue.image)}")
                }
                assertEquals(expected, order) { "round $round, ${queue.javaClass.simpleName}" }
            }
        }
    }

    @Test
    fun `what lives outlasts a store that is full of what does not`() {
        for (seed in 1L..20L) {
            val random = SeededRandom(seed)
            val (slow, fast) = queues()
            val ids = IntArray(SLOTS) { it }
            repeat(2) {
                for (queue in listOf(slow, fast)) queue.reset(1.0, ids, SLOTS)
                var now = 0.0
                repeat(6_000) { k ->
                    val a = random.nextInt(SLOTS)
                    val e = Event(random.nextDouble(now, 1.0), a, (a + 1 + random.nextInt(SLOTS - 1)) % SLOTS, k % 5)
                    slow.add(e)
                    fast.add(e)
                    if (k % 3 == 0) for (queue in listOf(slow, fast)) queue.removeAllOf(e.second)
                    if (k % 9 == 0) now = popBoth(slow, fast, "seed $seed, event $k") ?: now
                }
                while (popBoth(slow, fast, "seed $seed, at the end") != null) continue
            }
        }
    }

    /** @return the time, null when both are empty */
    private fun popBoth(slow: EventQueue, fast: EventQueue, story: String): Double? {
        val isThere = slow.pop()
        assertEquals(isThere, fast.pop()) { story }
        if (!isThere) return null
        assertEquals(slow.time, fast.time) { story }
        assertEquals(listOf(slow.first, slow.second, slow.image), listOf(fast.first, fast.second, fast.image)) { story }
        return slow.time
    }

    @Test
    fun `an event at the very end of a step comes out, however many buckets there are`() {
        for (queue in queues()) {
            for (step in 1..3) {
                queue.reset(1.0, IntArray(1001) { it }, 1001)
                for (k in 1..1000) queue.add(1.0, 0, k, 0)
                for (k in 1..1000) assertTrue(queue.pop()) { "step $step, event $k, ${queue.javaClass.simpleName}" }
                assertFalse(queue.pop())
            }
        }
    }

    private companion object {
        const val SLOTS = 300
    }
}
