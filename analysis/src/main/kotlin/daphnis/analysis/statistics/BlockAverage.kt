package daphnis.analysis.statistics

import kotlin.math.sqrt

/**
 * The average of a series that is correlated in time, and its error by block averaging (Flyvbjerg & Petersen 1989, J. Chem. Phys. 91, 461): neighbours are averaged
 * in pairs again and again; the error of the mean computed from blocks grows until blocks are longer than the correlation, and its largest value, as long
 * as there are [FEWEST_BLOCKS] blocks, is taken.
 *
 * @property mean NaN for an empty series
 * @property error one standard error; NaN for fewer than two numbers
 * @property count numbers in the series
 */
public class BlockAverage(public val mean: Double, public val error: Double, public val count: Int) {
    override fun toString(): String = "$mean ± $error"

    public companion object {
        private const val FEWEST_BLOCKS = 8

        /** Of [series], in order of time. */
        public fun of(series: DoubleArray): BlockAverage {
            val n = series.size
            if (n == 0) return BlockAverage(Double.NaN, Double.NaN, 0)
            val mean = series.sum() / n
            if (n == 1) return BlockAverage(mean, Double.NaN, 1)
            var blocks = series
            var error = 0.0
            do {
                error = maxOf(error, standardError(blocks))
                blocks = DoubleArray(blocks.size / 2) { (blocks[2 * it] + blocks[2 * it + 1]) / 2 }
            } while (blocks.size >= FEWEST_BLOCKS)
            return BlockAverage(mean, error, n)
        }

        private fun standardError(a: DoubleArray): Double {
            val mean = a.sum() / a.size
            var square = 0.0
            for (v in a) square += (v - mean) * (v - mean)
            return sqrt(square / (a.size - 1.0) / a.size)
        }
    }
}
