package daphnis.analysis.statistics

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.hypot
import kotlin.math.ln
import kotlin.math.pow
import kotlin.math.sin
import kotlin.math.sqrt

class BlockAverageTest {
    /** Gaussian numbers of mean 0 and variance 1 that forget within [memory]; independent for 0. */
    private fun series(n: Int, memory: Double, random: SeededRandom): DoubleArray {
        val keep = if (memory == 0.0) 0.0 else exp(-1 / memory)
        var v = random.nextGaussian()
        return DoubleArray(n) { v.also { v = keep * v + sqrt(1 - keep * keep) * random.nextGaussian() } }
    }

    @Test
    fun `a small scatter of large numbers has an error, and rounding has none`() {
        val random = SeededRandom(31)
        val small = BlockAverage.of(DoubleArray(1000) { 1e6 + 1e-5 * random.nextGaussian() })
        assertEquals(1.0, small.error / (1e-5 / sqrt(1000.0)), 0.5)
        assertEquals(0.0, BlockAverage.of(DoubleArray(1000) { 0.1 * (1 + it % 3 * 2e-16) }).error)
    }

    @Test
    fun `one standard error covers the truth in 60 to 75 percent, or the series is said to be too short`() {
        for (n in listOf(8, 20, 100, 1000, 5000)) {
            for (memory in listOf(0.0, 2.0, 5.0, 10.0, 50.0)) {
                val random = SeededRandom(11)
                var given = 0
                var covered = 0
                var far = 0
                repeat(REALISATIONS) {
                    val a = BlockAverage.of(series(n, memory, random))
                    if (a.isLevelled) given++
                    if (a.isLevelled && abs(a.mean) <= a.error) covered++
                    if (abs(a.mean) > 3 * a.error) far++
                }
                val what = "$n numbers, memory $memory: $covered of $given of $REALISATIONS"
                if (given > REALISATIONS * 2 / 3) assertTrue(covered.toDouble() / given in 0.60..0.75) { what }
                if (n >= 100 &&
                    n >= 100 * memory
                ) {
                    assertTrue(far < 0.03 * REALISATIONS) { "$what, $far beyond 3 errors" }
                }
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
        // Where the series is cut off, one of the two may be without the other: 1/4096.
        assertEquals(hypot(0.01 / 64, 1.0 / 4096), alternating.error, 1e-4)
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
            assertTrue(quotient.error < 0.5 * BlockAverage.of(b).error) { "not less than of independent parts" }
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

    /** What [REALISATIONS] series of mean 0 show: the part whose ± reaches it, and spread over ±. */
    private fun hold(name: String, covered: ClosedRange<Double>, spread: ClosedRange<Double>, one: () -> DoubleArray) {
        val all = List(REALISATIONS) { BlockAverage.of(one()) }
        val given = all.filter { it.isLevelled }
        val part = given.count { abs(it.mean) <= it.error } / given.size.toDouble()
        val over = sqrt(given.sumOf { it.mean * it.mean } / given.sumOf { it.error * it.error })
        assertTrue(given.size >= 0.9 * REALISATIONS && part in covered && over in spread) {
            "$name: $part of ${given.size} covered, spread/± $over"
        }
    }

    /** Numbers that swing with [period], forget within [memory], and have variance 1 more or less. */
    private fun swinging(n: Int, period: Double, memory: Double, random: SeededRandom): DoubleArray {
        val keep = exp(-1 / memory)
        val turn = 2 * PI / period
        var (x, y) = random.nextGaussian() to random.nextGaussian()
        val noise = sqrt(1 - keep * keep)
        return DoubleArray(n) {
            val next = keep * (cos(turn) * x - sin(turn) * y) + noise * random.nextGaussian()
            y = keep * (sin(turn) * x + cos(turn) * y) + noise * random.nextGaussian()
            next.also { x = it }
        }
    }

    @Test
    fun `a fast oscillation neither hides a slow part nor makes the error larger`() {
        val random = SeededRandom(8)
        hold("swings", 0.60..0.75, 0.88..1.12) { swinging(500, 10.0, 10.0, random) }
        hold("swings, slow part", 0.60..0.75, 0.88..1.12) {
            val slow = series(2500, 60.0, random)
            swinging(2500, 50.0, 50.0, random).also { for (k in it.indices) it[k] += 0.4 * slow[k] }
        }
    }

    @Test
    fun `an oscillation of any period but a slow one leaves the error as it is`() {
        // By all twelve ordinates alone 38 % at twelve periods, and spread/± 1.6.
        for ((n, periods) in listOf(300 to 12.0, 300 to 12.4, 300 to 13.0, 116 to 12.0, 116 to 14.5, 116 to 40.6)) {
            val random = SeededRandom(12)
            val (covered, spread) = 0.60..0.76 to 0.75..1.1
            hold("$n numbers, $periods periods", covered, spread) {
                val phase = 2 * PI * random.nextDouble()
                DoubleArray(n) { random.nextGaussian() + 2 * cos(2 * PI * periods * (it + 0.5) / n + phase) }
            }
        }
    }

    @Test
    fun `changes of something that stays the same on average have a small error`() {
        val random = SeededRandom(9)
        val state = { series(2001, 3.0, random) }
        // Of nothing but changes some are too large, since an oscillation must not make any too small.
        hold("changes", 0.5..0.97, 0.6..1.1) { state().let { e -> DoubleArray(2000) { e[it + 1] - e[it] } } }
        hold("changes and noise", 0.6..0.8, 0.7..1.1) {
            state().let { e -> DoubleArray(2000) { e[it + 1] - e[it] + 0.05 * random.nextGaussian() } }
        }
        // Known to be changes of a state, they need not be long: here seven times as long as the state remembers.
        val all = List(REALISATIONS) {
            val e = series(201, 30.0, random)
            val x = DoubleArray(200) { 1 + 2 * (e[it + 1] - e[it]) + 0.01 * random.nextGaussian() }
            BlockAverage.of(arrayOf(x), arrayOf(DoubleArray(201), e, DoubleArray(201) { 3 * e[it] })) { it[0] }
        }
        val part = all.count { abs(it.mean - 1) <= it.error } / REALISATIONS.toDouble()
        val spread = sqrt(all.sumOf { (it.mean - 1) * (it.mean - 1) } / all.sumOf { it.error * it.error })
        assertTrue(part in 0.60..0.80 && spread in 0.85..1.1) { "$part covered, spread/± $spread" }
        assertThrows(IllegalArgumentException::class.java) {
            BlockAverage.of(arrayOf(series(40, 0.0, random)), arrayOf(DoubleArray(40))) { it[0] }
        }
    }

    @Test
    fun `the error does not depend on how often the numbers are taken`() {
        val random = SeededRandom(10)
        for (slow in listOf(40.0, 100.0)) {
            val squares = DoubleArray(3)
            repeat(50) {
                val one = series(10_000, slow, random)
                // Collisions between rows are summed, states are looked at: both keep what is slow.
                for ((k, every) in listOf(1, 10, 50).withIndex()) {
                    val looked = BlockAverage.of(DoubleArray(10_000 / every) { one[it * every] }).error
                    val summed = BlockAverage.of(
                        DoubleArray(10_000 / every) { row -> (0 until every).sumOf { one[row * every + it] } / every },
                    ).error
                    squares[k] += looked * looked + summed * summed
                }
            }
            for (k in 1..2) assertEquals(1.0, sqrt(squares[k] / squares[0]), 0.1) { "memory $slow: $k" }
        }
    }

    @Test
    fun `two halves of a series differ by as much as their errors say`() {
        val random = SeededRandom(12)
        var square = 0.0
        repeat(REALISATIONS) {
            val halves = swinging(1000, 20.0, 30.0, random).let { listOf(it.copyOf(500), it.copyOfRange(500, 1000)) }
            val (a, b) = halves.map { BlockAverage.of(it) }
            square += (a.mean - b.mean) * (a.mean - b.mean) / (a.error * a.error + b.error * b.error)
        }
        assertEquals(1.0, sqrt(square / REALISATIONS), 0.15)
    }

    @Test
    fun `neither a unit nor a large mean changes what an error is, and a million numbers have one`() {
        val x = series(300, 3.0, SeededRandom(13))
        val error = BlockAverage.of(x).error
        for (unit in listOf(1e-200, 1e-9, 1e200)) {
            val scaled = BlockAverage.of(DoubleArray(300) { x[it] * unit })
            assertEquals(error, scaled.error / unit, 1e-9 * error)
            assertEquals(BlockAverage.of(x).independent, scaled.independent, 1e-6)
        }
        assertEquals(error, BlockAverage.of(DoubleArray(300) { x[it] + 1e6 }).error, 1e-6 * error)
        assertEquals(1e-3, BlockAverage.of(series(1_000_000, 0.0, SeededRandom(15))).error, 4e-4)
    }

    /** S(0) of the more likely curve, by sums as they are written, over corners close together. */
    private fun plainly(x: List<Double>): Double {
        val n = x.size
        val mean = x.average()
        val ordinates = (1..minOf(12, (n - 1) / 2)).map { j ->
            val re = x.indices.sumOf { (x[it] - mean) * cos(2 * PI * j * it / n) }
            val im = x.indices.sumOf { (x[it] - mean) * sin(2 * PI * j * it / n) }
            (re * re + im * im) / n
        }
        val (level, rises) = likeliest(ordinates)
        return if (rises) maxOf(level, likeliest(ordinates.take((ordinates.size + 1) / 2)).first) else level
    }

    /** Its level at frequency 0, and whether it rises. */
    private fun likeliest(ordinates: List<Double>): Pair<Double, Boolean> {
        val fits = (1..2000).flatMap { step ->
            listOf(-1, 1).map { power ->
                val shape = ordinates.indices.map { (1 + ((it + 1) / (0.25 * exp(step * 0.003))).pow(2)).pow(power) }
                val level = ordinates.indices.map { ordinates[it] / shape[it] }.average()
                shape.sumOf { ln(it) } + ordinates.size * ln(level) + (if (power > 0) 2.0 else 0.5) to
                    (level to (power > 0))
            }
        }.plusElement(ordinates.size * ln(ordinates.average()) to (ordinates.average() to false))
        return fits.minBy { it.first }.second
    }

    private fun neighbouring(n: Int, seed: Long, keep: Double = 0.3): List<Double> {
        val random = SeededRandom(seed)
        var last = 0.0
        return List(n) {
            last = keep * last + random.nextDouble(-1.0, 1.0)
            5 + last
        }
    }

    private fun assertPlain(plain: List<Double>, average: BlockAverage) {
        val n = plain.size
        val variance = plain.sumOf { (it - plain.average()) * (it - plain.average()) } / (n - 1)
        val spectrum = maxOf(plainly(plain), variance / n)
        val error = sqrt(spectrum / n * (1 + 3 / average.independent))
        assertEquals(error, average.error, 0.04 * error) { "$n numbers" }
        assertTrue(average.independent <= n * variance / spectrum * 1.05)
    }

    @Test
    fun `the error is that of a curve through the twelve lowest frequencies`() {
        for ((n, keep) in listOf(16 to 0.0, 17 to 0.2, 60 to 0.3, 127 to 0.6, 128 to -0.8, 1000 to 0.9)) {
            val series = neighbouring(n, n.toLong(), keep)
            assertPlain(series, BlockAverage.of(series.toDoubleArray()))
            assertEquals(n, BlockAverage.of(series.toDoubleArray()).count)
        }
        assertTrue(BlockAverage.of(neighbouring(15, 1, 0.0).toDoubleArray()).error.isNaN())
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
