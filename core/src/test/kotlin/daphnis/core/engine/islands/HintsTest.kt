package daphnis.core.engine.islands

import daphnis.core.initial.SeededRandom
import daphnis.core.queue.EventStore.Companion.NONE
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class HintsTest {
    private data class Hint(val time: Double, val first: Int, val second: Int, val image: Int)

    private fun Hints.of(slice: Int): List<Hint> = buildList {
        var e = head(slice)
        while (e != NONE) {
            add(Hint(store.time(e), store.first(e), store.second(e), store.image(e)))
            e = store.link(e)
        }
        reverse()
    }

    /** The slice in its plainest form: the first that ends at [time] or later. */
    private fun sliceOf(time: Double, duration: Double) =
        (0 until Hints.SLICES).first { time <= Hints.endOf(it, duration) }

    private fun drawTime(random: SeededRandom, duration: Double): Double {
        val border = Hints.endOf(random.nextInt(Hints.SLICES), duration)
        return when (random.nextInt(6)) {
            0 -> 0.0
            1 -> duration
            2 -> border
            3 -> minOf(duration, Math.nextUp(border))
            4 -> Math.nextDown(border)
            else -> random.nextDouble() * duration
        }
    }

    @Test
    fun `every hint is in the slice of its time, in the order of its coming`() {
        val hints = Hints()
        for (seed in 1L..60L) {
            val random = SeededRandom(seed)
            val duration = doubleArrayOf(1.0, 0.3, 1.0 / 3.0, 1e-300, 1e300, 256.0, 7e-5)[random.nextInt(7)]
            hints.reset(duration, IslandLimits(10))
            val expected = List(Hints.SLICES) { ArrayList<Hint>() }
            repeat(random.nextInt(3000)) {
                val hint = Hint(drawTime(random, duration), random.nextInt(1000), random.nextInt(1000) - 6, it)
                expected[sliceOf(hint.time, duration)] += hint
                hints.add(hint.time, hint.first, hint.second, hint.image)
            }
            for (slice in expected.indices) {
                // Newest first in the list, so the oldest first when it is turned round.
                assertEquals(expected[slice], hints.of(slice)) { "seed $seed, slice $slice" }
                assertEquals(expected[slice].size, hints.count(slice)) { "seed $seed, slice $slice" }
            }
        }
    }

    @Test
    fun `slices cover the step to its last bit`() {
        for (duration in doubleArrayOf(0.1, 1.0 / 3.0, 1e-310, Double.MAX_VALUE)) {
            assertEquals(duration, Hints.endOf(Hints.SLICES - 1, duration))
            for (slice in 1 until Hints.SLICES) {
                assertTrue(Hints.endOf(slice - 1, duration) <= Hints.endOf(slice, duration)) { "$duration, $slice" }
            }
        }
    }
}
