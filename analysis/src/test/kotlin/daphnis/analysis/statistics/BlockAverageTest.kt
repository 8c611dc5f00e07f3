package daphnis.analysis.statistics

import daphnis.core.setup.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

class BlockAverageTest {
    @Test
    fun `the error of independent numbers is their deviation over the root of their number`() {
        val random = SeededRandom(1)
        val a = BlockAverage.of(DoubleArray(20_000) { 3 + 2 * random.nextGaussian() })
        assertEquals(3.0, a.mean, 4 * a.error)
        assertTrue(a.error / (2 / sqrt(20_000.0)) in 0.95..2.0)
    }

    @Test
    fun `numbers that remember for a time τ have an error larger by the root of 2 τ`() {
        val random = SeededRandom(2)
        val memory = 0.95
        var v = 0.0
        val series = DoubleArray(100_000) {
            v = memory * v + sqrt(1 - memory * memory) * random.nextGaussian()
            v
        }
        // Σ of the correlations 0.95^k on both sides: (1 + 0.95)/(1 − 0.95) = 39.
        val expected = sqrt(39.0 / 100_000)
        assertTrue(BlockAverage.of(series).error / expected in 0.75..1.6)
    }

    @Test
    fun `nothing, one number and a constant`() {
        assertTrue(BlockAverage.of(DoubleArray(0)).mean.isNaN())
        assertTrue(BlockAverage.of(doubleArrayOf(4.0)).let { it.mean == 4.0 && it.error.isNaN() })
        assertEquals(0.0, BlockAverage.of(DoubleArray(50) { 4.0 }).error)
    }
}
