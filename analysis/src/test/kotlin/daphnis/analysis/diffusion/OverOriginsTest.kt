package daphnis.analysis.diffusion

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.Random
import kotlin.math.abs
import kotlin.math.sqrt

/** Errors of averages over origins. */
class OverOriginsTest {
    /** What the first difference of a series leaves of its mean is next to nothing: its spectrum is low at 0. */
    private fun antiCorrelated(n: Int): DoubleArray {
        val random = Random(3)
        val noise = DoubleArray(n + 1) { random.nextGaussian() }
        return DoubleArray(n) { 10 + noise[it + 1] - noise[it] }
    }

    @Test
    fun `no error is below a part of that of blocks that know nothing of one another`() {
        val series = antiCorrelated(4096)
        fun error(least: Double) = OverOrigins.error(arrayOf(series), 64, least) { it[0] }
        val measured = error(0.0)
        val blocks = DoubleArray(64) { b -> (0 until 64).sumOf { series[64 * b + it] } / 64 }
        val mean = blocks.average()
        val apart = sqrt(blocks.sumOf { (it - mean) * (it - mean) } / 63 / 64)
        assertTrue(measured < 0.7 * apart) { "$measured of $apart" }
        assertEquals(apart, error(1.0), 1e-9)
        assertEquals(2 * apart, error(2.0), 1e-9)
        assertEquals(measured, error(0.1 * measured / apart), 1e-12)
    }

    @Test
    fun `errors reach the mean in two thirds of cases, of few blocks and of many`() {
        for (windows in listOf(8, 20, 48)) {
            val length = 16
            val cases = 400
            val random = Random(windows.toLong())
            val reached = (1..cases).count {
                // Squares of a walk over the time of a lag, which neighbouring origins share.
                val step = DoubleArray(windows * length + length) { random.nextGaussian() }
                val sum = DoubleArray(step.size + 1)
                for (k in step.indices) sum[k + 1] = sum[k] + step[k]
                val series = DoubleArray(windows * length) { (sum[it + length] - sum[it]).let { d -> d * d } / length }
                abs(series.average() - 1) < OverOrigins.error(series, length)
            }
            assertTrue(reached in cases * 58 / 100..cases * 75 / 100) { "$reached of $cases with $windows windows" }
        }
    }
}
