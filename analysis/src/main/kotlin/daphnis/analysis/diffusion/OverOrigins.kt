package daphnis.analysis.diffusion

import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.statistics.OfMeans
import kotlin.math.sqrt

/**
 * Errors of averages over origins: each number of a series is over the time of some places from an origin on, so blocks
 * of at least that length go through [BlockAverage].
 */
internal object OverOrigins {
    /**
     * Squares of a random walk over the times of neighbouring windows have the correlation 1/6: ∫u(1 − u)² over
     * ∫(1 − u)³, twice.
     */
    private const val OVERLAP = 4.0 / 3
    private const val FEWEST_MEASURED = 32
    private const val FEWEST_BLOCKS = 4

    /** One standard error of the average of [series], each number of which is over the time of [length] places. */
    fun error(series: DoubleArray, length: Int): Double {
        val windows = series.size / length
        return when {
            windows < MeanSquareDisplacement.FEWEST_WINDOWS -> Double.NaN
            // Too few to measure how they are correlated: only what they have in common by overlapping is known.
            windows < FEWEST_MEASURED -> scatter(series, length) * sqrt(OVERLAP)
            else -> BlockAverage.of(blocks(series, windows)).error
        }
    }

    /**
     * The same of a [function] of the means of [columns], by its jackknife pseudovalues over blocks.
     *
     * @param least no error is less than this part of what blocks that know nothing of one another would have: of sums
     *   over events that are nearly independent a spectrum that is low by chance tells less than that
     */
    fun error(columns: Array<DoubleArray>, length: Int, least: Double = 0.0, function: OfMeans): Double {
        val windows = columns[0].size / length
        if (windows < MeanSquareDisplacement.FEWEST_WINDOWS) return Double.NaN
        val blocks = Array(columns.size) { blocks(columns[it], windows) }
        val isMeasured = windows >= FEWEST_MEASURED
        val measured = if (isMeasured) BlockAverage.of(blocks, function).error else Double.NaN
        if (isMeasured && (measured.isNaN() || least == 0.0)) return measured
        val sums = DoubleArray(columns.size) { blocks[it].sum() }
        val without = DoubleArray(windows) { w ->
            function.of(DoubleArray(columns.size) { (sums[it] - blocks[it][w]) / (windows - 1) })
        }
        val mean = without.average()
        val apart = sqrt(without.sumOf { (it - mean) * (it - mean) } * (windows - 1) / windows)
        return if (isMeasured) maxOf(measured, least * apart) else apart * sqrt(OVERLAP)
    }

    /** A rough error of the average of [series], also where there are few blocks of [length] places. */
    fun scatter(series: DoubleArray, length: Int): Double {
        val blocks = blocks(series, (series.size / length).coerceIn(FEWEST_BLOCKS, series.size))
        val mean = blocks.average()
        return sqrt(blocks.sumOf { (it - mean) * (it - mean) } / (blocks.size - 1.0) / blocks.size)
    }

    private fun blocks(series: DoubleArray, count: Int) = DoubleArray(count) { b ->
        val begin = (series.size.toLong() * b / count).toInt()
        val end = (series.size.toLong() * (b + 1) / count).toInt()
        (begin until end).sumOf { series[it] } / (end - begin)
    }
}
