package daphnis.analysis.statistics

import kotlin.math.abs
import kotlin.math.sqrt

/**
 * The average of a series that is correlated in time, with its standard error, or the verdict that the series is too
 * short for an error.
 *
 * Neighbours in time are averaged in pairs until there are fewer than [MOST_BLOCKS] blocks (Flyvbjerg & Petersen 1989,
 * J. Chem. Phys. 91, 461). The correlation r that remains between neighbouring blocks enlarges the squared error by (1
 * + r)/(1 − r), as in a first-order autoregressive series. r is the measured lag-1 correlation, corrected for its bias
 * −(1 + 4r)/n (Marriott & Pope 1954, Biometrika 41, 390), and never below 0. The m blocks so count as m (1 − r)/(1 + r)
 * [independent] ones. With fewer than [FEWEST_INDEPENDENT] of these, or fewer than [FEWEST_NUMBERS] numbers, too few to
 * estimate the correlation, [error] is NaN. Where most series of a kind get an error, it covers the true value in 60 to
 * 75 % of them (docs/adr/0013).
 *
 * @property mean NaN for an empty series
 * @property error one standard error; NaN unless the average [isLevelled]
 * @property count numbers in the series
 * @property independent independent blocks that the series is worth, at most [MOST_BLOCKS]; NaN where this is not known
 */
public class BlockAverage @JvmOverloads constructor(
    public val mean: Double,
    public val error: Double,
    public val count: Int,
    public val independent: Double = Double.NaN,
) {
    /** Whether there are enough independent blocks for an [error]. */
    public val isLevelled: Boolean get() = !error.isNaN()

    /** This average in a unit smaller by [factor]. */
    public operator fun times(factor: Double): BlockAverage =
        BlockAverage(mean * factor, error * abs(factor), count, independent)

    /** The root of this average; its error is half as large, relative to it. */
    public fun root(): BlockAverage = sqrt(mean).let {
        BlockAverage(
            it,
            if (error == 0.0) {
                0.0
            } else {
                error / (2 * it)
            },
            count,
            independent,
        )
    }

    /** This average without an error, for callers that know from elsewhere that none can be given. */
    internal fun withoutError() = BlockAverage(mean, Double.NaN, count, independent)

    override fun toString(): String =
        if (isLevelled) "$mean ± $error" else "$mean (error unknown: too few independent numbers)"

    public companion object {
        /** Independent blocks below which no error is given. */
        public const val FEWEST_INDEPENDENT: Double = 8.0

        /** Length of a series below which no error is given. */
        public const val FEWEST_NUMBERS: Int = 16

        /** Blocks are made longer until there are fewer than these. */
        public const val MOST_BLOCKS: Int = 128

        private const val STRONGEST = 0.999

        /** Scatter of the pseudovalues of a constant, in units of their number and size. */
        private const val ROUNDING = 1e-13

        /** Of [series], in order of time. */
        @JvmStatic
        public fun of(series: DoubleArray): BlockAverage {
            val n = series.size
            if (n == 0) return BlockAverage(Double.NaN, Double.NaN, 0, 0.0)
            return of(series, series.sum() / n)
        }

        /**
         * A function of the means of [columns], series of equal length and in order of time, such as a ratio Σa / Σb.
         * Its error is that of the series of its jackknife pseudovalues n θ − (n − 1) θ₋ᵢ (Tukey 1958; Miller 1974,
         * Biometrika 61, 1), which includes what the columns have in common.
         */
        @JvmStatic
        public fun of(columns: Array<DoubleArray>, function: OfMeans): BlockAverage {
            val n = columns[0].size
            for (column in columns) {
                require(column.size == n) {
                    "a column has ${column.size} numbers, the first has $n"
                }
            }
            if (n == 0) return BlockAverage(Double.NaN, Double.NaN, 0, 0.0)
            val sums = DoubleArray(columns.size) { columns[it].sum() }
            val whole = function.of(DoubleArray(sums.size) { sums[it] / n })
            if (n < 2) return BlockAverage(whole, Double.NaN, n, Double.NaN)
            val means = DoubleArray(sums.size)
            val pseudovalues = DoubleArray(n) { i ->
                for (k in sums.indices) means[k] = (sums[k] - columns[k][i]) / (n - 1)
                whole + (n - 1) * (whole - function.of(means))
            }
            return of(pseudovalues, whole)
        }

        /** [mean], with the error of the average of [series]. */
        internal fun of(series: DoubleArray, mean: Double): BlockAverage {
            val n = series.size
            var blocks = series
            while (blocks.size >= MOST_BLOCKS) {
                val finer = blocks
                blocks = DoubleArray(finer.size / 2) { (finer[2 * it] + finer[2 * it + 1]) / 2 }
            }
            val m = blocks.size
            val centre = blocks.sum() / m
            var square = 0.0
            var neighbours = 0.0
            for (k in blocks.indices) {
                square += (blocks[k] - centre) * (blocks[k] - centre)
                if (k > 0) neighbours += (blocks[k] - centre) * (blocks[k - 1] - centre)
            }
            if (n < FEWEST_NUMBERS || square.isNaN()) return BlockAverage(mean, Double.NaN, n, Double.NaN)
            if (sqrt(square / m) <= ROUNDING * n * abs(mean)) return BlockAverage(mean, 0.0, n, m.toDouble())
            val correlation = ((m * neighbours / square + 1) / (m - 4)).coerceIn(0.0, STRONGEST)
            val independent = m * (1 - correlation) / (1 + correlation)
            if (independent < FEWEST_INDEPENDENT) return BlockAverage(mean, Double.NaN, n, independent)
            return BlockAverage(mean, sqrt(square / m / (independent - 1)), n, independent)
        }
    }
}

/** A function of the means of columns, given in the order of the columns. */
public fun interface OfMeans {
    /** The number for [means]; the array is used again. */
    public fun of(means: DoubleArray): Double
}
