package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.statistics.Steadiness.Verdict
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sqrt

class SteadyStartTest {
    private val time = DoubleArray(1000) { it * 1.0 }

    /** Gaussian numbers of mean 3 and deviation 1 that forget within [memory], plus a [signal]. */
    private fun history(random: SeededRandom, memory: Double, signal: (Int) -> Double): History {
        val keep = exp(-1 / memory)
        var v = random.nextGaussian()
        return History(
            "a",
            time,
            DoubleArray(time.size) {
                3 + signal(it) + v.also { v = keep * v + sqrt(1 - keep * keep) * random.nextGaussian() }
            },
        )
    }

    private fun start(history: History) = SteadyStart.of(375.0) { listOf(history) }

    /** How many of the series get an error, and how many of these errors cover the true mean. */
    private fun coverage(memory: Double, signal: (Int) -> Double): Triple<Int, Int, Int> {
        val random = SeededRandom(31)
        var given = 0
        var covered = 0
        var found = 0
        repeat(REALISATIONS) {
            val h = history(random, memory, signal)
            val start = start(h)
            if (start.isFound) found++
            if (h.steadiness(start.from).verdict != Verdict.STEADY) return@repeat
            val mean = BlockAverage.of(h.values.copyOfRange(h.first(start.from), h.values.size))
            if (!mean.isLevelled) return@repeat
            given++
            if (abs(mean.mean - 3) <= mean.error) covered++
        }
        return Triple(given, covered, found)
    }

    @Test
    fun `errors from the steady time on cover the truth in 60 to 75 percent, early and late transient alike`() {
        for (memory in listOf(1.0, 3.0)) {
            for (end in listOf(0, 200, 450)) {
                val (given, covered, found) = coverage(memory) { k -> if (k < end) 20.0 * (end - k) / end else 0.0 }
                val what = "memory $memory, transient to $end: $covered of $given of $REALISATIONS, found $found"
                assertTrue(given >= 0.9 * REALISATIONS) { what }
                assertTrue(covered.toDouble() / given in 0.60..0.77) { what }
                assertTrue(if (end > 375) found > 0.45 * REALISATIONS else found < 0.05 * REALISATIONS) { what }
            }
        }
    }

    @Test
    fun `a run that never becomes steady gets no error`() {
        val (given, _, found) = coverage(2.0) { k -> 10.0 * k / time.size }
        assertTrue(given <= 0.02 * REALISATIONS && found == 0) { "$given, $found" }
    }

    @Test
    fun `the last quantity to become steady decides, and one that never does leaves the usual time`() {
        val random = SeededRandom(3)
        fun falls(end: Int) = history(random, 1.0) { k -> if (k < end) 20.0 * (end - k) / end else 0.0 }
        val both = listOf(falls(420), falls(460))
        val start = SteadyStart.of(375.0) { both }
        assertTrue(start.isFound && start.from in 440.0..500.0) { "${start.from}" }
        val never = both + history(random, 1.0) { k -> 0.1 * k }
        assertEquals(375.0, SteadyStart.of(375.0) { never }.from)
        assertEquals(375.0, SteadyStart.of(375.0) { emptyList() }.from)
    }

    @Test
    fun `numbers without a steady time have no error, and say why`() {
        val row = NumberRow("a", 1.0, 0.1, "m", key = "a").without(Unknown.UNSTEADY)
        assertTrue(row.error.isNaN() && row.unknown == Unknown.UNSTEADY && row.value == 1.0 && row.key == "a")
        val exact = NumberRow("a", 1.0, Double.NaN, "m", key = "a")
        assertTrue(exact.without(Unknown.UNSTEADY) === exact)
    }

    private companion object {
        const val REALISATIONS = 200
    }
}
