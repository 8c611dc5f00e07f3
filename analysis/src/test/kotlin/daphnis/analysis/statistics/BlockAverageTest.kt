package daphnis.analysis.statistics

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sqrt

class BlockAverageTest {
    /** Gaussian numbers of mean 0 and variance 1 that forget within [memory]; independent for 0. */
    private fun series(n: Int, memory: Double, random: SeededRandom): DoubleArray {
        val keep = if (memory == 0.0) 0.0 else exp(-1 / memory)
        var v = random.nextGaussian()
        return DoubleArray(n) { v.also { v = keep * v + sqrt(1 - keep * keep) * random.nextGaussian() } }
    }

    @Test
    fun `one standard error covers the truth in 60 to 75 percent, or the series is said to be too short`() {
        for (n in listOf(8, 20, 100, 1000, 5000)) {
            for (memory in listOf(0.0, 2.0, 5.0, 10.0, 50.0)) {
                val random = SeededRandom(11)
                var given = 0
                var covered = 0
                repeat(REALISATIONS) {
                    val a = BlockAverage.of(series(n, memory, random))
                    if (a.isLevelled) given++
                    if (a.isLevelled && abs(a.mean) <= a.error) covered++
                }
                val what = "$n numbers, memory $memory: $covered of $given of $REALISATIONS"
                if (given > REALISATIONS * 2 / 3) assertTrue(covered.toDouble() / given in 0.60..0.75) { what }
                // Nothing is missed often: neither where errors are given as a rule nor where they slip through.
                assertTrue(given - covered < 0.4 * REALISATIONS) { what }
                if (n < BlockAverage.FEWEST_NUMBERS || memory > 0 && n < 5 * memory) {
                    assertTrue(given < 0.16 * REALISATIONS) { what }
                }
                if (memory == 0.0 && n >= 20 || n >= 40 * memory && n >= 100) {
                    assertTrue(given > 0.9 * REALISATIONS) { what }
                }
            }
        }
    }

    @Test
    fun `slow numbers hidden in fast noise are found, and numbers that alternate make no larger an error`() {
        val random = SeededRandom(4)
        var covered = 0
        repeat(400) {
            val slow = series(2000, 30.0, random)
            val a = BlockAverage.of(DoubleArray(2000) { slow[it] + 3 * random.nextGaussian() })
            if (abs(a.mean) <= a.error) covered++
        }
        assertTrue(covered / 400.0 in 0.60..0.75) { "$covered" }
        val alternating = BlockAverage.of(
            DoubleArray(4096) {
                (if (it % 2 == 0) 1.0 else -1.0) +
                    0.01 * random.nextGaussian()
            },
        )
        assertTrue(alternating.error / (0.01 / 64) in 0.8..1.3)
    }

    @Test
    fun `the error of a ratio and of a sum keeps what the parts have in common`() {
        val random = SeededRandom(5)
        var ratio = 0
        var sum = 0
        repeat(400) {
            val a = series(200, 0.0, random)
            val b = DoubleArray(200) { 2 + 0.5 * a[it] + 0.05 * random.nextGaussian() }
            val c = DoubleArray(200) { 4 + a[it] }
            val quotient = BlockAverage.of(arrayOf(b, c)) { it[0] / it[1] }
            if (abs(quotient.mean - 0.5) <= quotient.error) ratio++
            assertTrue(quotient.error < 0.3 * BlockAverage.of(b).error) { "not less than of independent parts" }
            val total = BlockAverage.of(arrayOf(b, c)) { it[0] + it[1] }
            if (abs(total.mean - 6) <= total.error) sum++
            assertEquals(BlockAverage.of(DoubleArray(200) { b[it] + c[it] }).error, total.error, 1e-10)
        }
        assertTrue(ratio / 400.0 in 0.60..0.75 && sum / 400.0 in 0.60..0.75) { "$ratio $sum" }
    }

    @Test
    fun `nothing, one number, too few, NaN, a drift and a constant`() {
        assertTrue(BlockAverage.of(DoubleArray(0)).mean.isNaN())
        assertTrue(BlockAverage.of(doubleArrayOf(4.0)).let { it.mean == 4.0 && it.error.isNaN() })
        assertFalse(BlockAverage.of(DoubleArray(15) { it % 3.0 }).isLevelled)
        assertFalse(BlockAverage.of(DoubleArray(50) { if (it == 20) Double.NaN else 1.0 * it }).isLevelled)
        val drift = BlockAverage.of(DoubleArray(500) { it * 0.1 })
        assertTrue(!drift.isLevelled && drift.independent < 8 && drift.mean == 24.95)
        assertTrue("too few independent" in drift.toString())
        assertEquals(0.0, BlockAverage.of(DoubleArray(50) { 4.0 }).error)
        assertTrue(BlockAverage.of(arrayOf(DoubleArray(0))) { it[0] }.mean.isNaN())
        assertFalse(BlockAverage.of(arrayOf(doubleArrayOf(2.0))) { it[0] }.isLevelled)
    }

    @Test
    fun `a scaled average and the root of one carry their errors`() {
        val a = BlockAverage(4.0, 0.4, 100, 50.0)
        assertEquals(1.2, (a * -3.0).error, 1e-12)
        assertEquals(-12.0, (a * -3.0).mean)
        assertEquals(2.0, a.root().mean)
        assertEquals(0.1, a.root().error, 1e-12)
        assertEquals(0.0, BlockAverage(0.0, 0.0, 20).root().error)
    }

    private fun neighbouring(n: Int, seed: Long): List<Double> {
        val random = SeededRandom(seed)
        var last = 0.0
        return List(n) {
            last = 0.3 * last + random.nextDouble(-1.0, 1.0)
            5 + last
        }
    }

    /** Independent numbers among [x], and the error of its mean, by the sums as they are written in a textbook. */
    private fun plainly(x: List<Double>): Pair<Double, Double> {
        val m = x.size
        val mean = x.average()
        val square = x.sumOf { (it - mean) * (it - mean) }
        val product = x.zipWithNext { a, b -> (a - mean) * (b - mean) }.sum()
        val correlation = maxOf(0.0, (m * product / square + 1) / (m - 4))
        val independent = m * (1 - correlation) / (1 + correlation)
        return independent to sqrt(square / m / (independent - 1))
    }

    private fun assertPlain(plain: List<Double>, average: BlockAverage) {
        val (independent, error) = plainly(plain)
        assertEquals(independent, average.independent, 1e-9)
        assertEquals(error, average.error, 1e-12)
    }

    @Test
    fun `a series is taken as it is below 128 numbers, and by pairs from there on`() {
        for (n in listOf(60, 100, 127)) {
            val series = neighbouring(n, n.toLong())
            assertPlain(series, BlockAverage.of(series.toDoubleArray()))
            assertEquals(n, BlockAverage.of(series.toDoubleArray()).count)
        }
        val long = neighbouring(128, 3)
        assertPlain(long.chunked(2).map { it.average() }, BlockAverage.of(long.toDoubleArray()))
    }

    @Test
    fun `sixteen numbers have an error, and fifteen have none`() {
        val turns = List(16) { 5 + if (it % 2 == 0) 1.0 else -1.0 }
        assertPlain(turns, BlockAverage.of(turns.toDoubleArray()))
        assertTrue(BlockAverage.of(turns.drop(1).toDoubleArray()).error.isNaN())
    }

    @Test
    fun `the error of a ratio is that of what each row adds to it`() {
        val a = neighbouring(40, 5)
        val b = neighbouring(40, 6)
        val ratio = a.sum() / b.sum()
        val pseudovalues = a.indices.map { 40 * ratio - 39 * (a.sum() - a[it]) / (b.sum() - b[it]) }
        val average = BlockAverage.of(arrayOf(a.toDoubleArray(), b.toDoubleArray())) { it[0] / it[1] }
        assertEquals(ratio, average.mean, 1e-14)
        assertPlain(pseudovalues, average)
    }

    private companion object {
        const val REALISATIONS = 500
    }
}
