package daphnis.analysis.statistics

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

class SampleMeanTest {
    @Test
    fun `mean and error of four numbers worked out by hand`() {
        val s = SampleMean.of(doubleArrayOf(1.0, 2.0, 4.0, 5.0))
        assertEquals(3.0, s.mean, 1e-15)
        assertEquals(sqrt(10.0 / 3 / 4), s.error, 1e-15)
        assertEquals(4, s.count)
    }

    @Test
    fun `one standard error covers the truth as often as Student says, in 60 to 75 percent of eight`() {
        for (n in listOf(2, 3, 4, 8, 20)) {
            val random = SeededRandom(21)
            val covered = (0 until REALISATIONS).count {
                val s = SampleMean.of(DoubleArray(n) { 5 + 2 * random.nextGaussian() })
                abs(s.mean - 5) <= s.error
            }
            val part = covered.toDouble() / REALISATIONS
            if (n >= 8) assertTrue(part in 0.60..0.75) { "$n numbers: $covered of $REALISATIONS" }
            assertEquals(SampleMean.coverage(n), part, 0.08) { "$n numbers" }
        }
    }

    @Test
    fun `coverage is that of tables of Student's t`() {
        for ((n, known) in listOf(2 to 0.5, 3 to 0.57735, 4 to 0.60900, 5 to 0.62610, 8 to 0.64940, 1000 to 0.68245)) {
            assertEquals(known, SampleMean.coverage(n), 2e-4) { "$n" }
        }
        assertThrows(IllegalArgumentException::class.java) { SampleMean.coverage(1) }
    }

    @Test
    fun `equal numbers have no scatter, one has no error, and what is not finite does not count`() {
        val equal = SampleMean.of(DoubleArray(3) { 0.1 })
        assertTrue(equal.mean == 0.1 && equal.error == 0.0 && equal.count == 3)
        val one = SampleMean.of(doubleArrayOf(Double.NaN, 7.0, Double.POSITIVE_INFINITY))
        assertTrue(one.mean == 7.0 && one.error.isNaN() && one.count == 1)
        val none = SampleMean.of(doubleArrayOf(Double.NaN))
        assertTrue(none.mean.isNaN() && none.error.isNaN() && none.count == 0)
    }

    @Test
    fun `numbers that differ in their last digits keep their scatter`() {
        val s = SampleMean.of(doubleArrayOf(1e9, 1e9 + 1e-3, 1e9 + 2e-3))
        assertEquals(1e-3 / sqrt(3.0), s.error, 1e-6)
    }

    private companion object {
        const val REALISATIONS = 200
    }
}
