package daphnis.analysis.correlation

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

class IndependentStatesTest {
    private val random = SeededRandom(5)

    /** Noise of which each number keeps the part [kept] of the one before. */
    private fun noise(states: Int, kept: Double): DoubleArray {
        var x = random.nextGaussian()
        return DoubleArray(states) {
            x = kept * x + sqrt(1 - kept * kept) * random.nextGaussian()
            x
        }
    }

    private fun maps(states: Int, kept: Double): List<DoubleArray> {
        val lags = List(25) { noise(states, kept) }
        return List(states) { k -> DoubleArray(lags.size) { lags[it][k] } }
    }

    /** Scatter of the average of [numbers] over the root mean square of its ±, and the part of ± that cover 0. */
    private fun judged(states: Int, kept: Double, numbers: () -> DoubleArray): Pair<Double, Double> {
        val found = List(RUNS) {
            val series = numbers()
            IndependentStates(maps(states, kept)).average(series.average(), series)
        }
        assertTrue(found.all { it.isLevelled })
        val spread = sqrt(found.sumOf { it.mean * it.mean } / found.sumOf { it.error * it.error })
        return spread to found.count { abs(it.mean) <= it.error } / RUNS.toDouble()
    }

    @Test
    fun `numbers of many states that are independent have the error of independent numbers`() {
        for (states in listOf(20, 200)) {
            val (spread, covered) = judged(states, 0.0) { noise(states, 0.0) }
            assertEquals(1.0, spread, 0.11) { "$states" }
            assertTrue(covered in 0.62..0.75) { "$states: $covered" }
        }
    }

    @Test
    fun `numbers that are slower than the noise of their maps, wholly or in part, are worth what they show`() {
        val wholly = judged(200, 0.0) { noise(200, 0.8) }
        val inPart =
            judged(200, 0.0) { noise(200, 0.0).also { a -> noise(200, 0.9).forEachIndexed { k, b -> a[k] += b } } }
        for ((spread, covered) in listOf(wholly, inPart)) {
            assertEquals(1.0, spread, 0.15)
            assertTrue(covered in 0.6..0.75) { "$covered" }
        }
    }

    @Test
    fun `numbers as slow as their maps are worth what the maps show`() {
        val (spread, covered) = judged(100, 0.8) { noise(100, 0.8) }
        assertEquals(1.0, spread, 0.15)
        assertTrue(covered in 0.6..0.76) { "$covered" }
    }

    @Test
    fun `states that are one have no error, and equal numbers the error 0`() {
        val same = List(20) { doubleArrayOf(1.0, 0.0, 1.0) }
        assertEquals(0.0, IndependentStates(same).average(2.0, DoubleArray(20) { 2.0 }).error)
        assertTrue(IndependentStates(same.take(15)).average(2.0, DoubleArray(15) { 2.0 }).error.isNaN())
    }

    private companion object {
        const val RUNS = 400
    }
}
