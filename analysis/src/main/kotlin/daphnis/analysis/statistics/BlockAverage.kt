package daphnis.analysis.statistics

import kotlin.math.abs
import kotlin.math.hypot
import kotlin.math.sqrt

/**
 * The average of a series that is correlated in time, with its standard error, or the verdict that the series is too
 * short for an error.
 *
 * The squared error is S(0)/n, with S the spectrum of the series and S(0) what the slowest fluctuations that the series
 * can show extrapolate to ([LowFrequencies]). Only these matter to an average. So a fast oscillation neither hides a
 * slow fluctuation nor makes the error larger, negative correlation makes it smaller, and it does not depend on how
 * often numbers were taken. An oscillation counts as fast when the series has more than [LowFrequencies.FREQUENCIES]
 * periods of it; a slower one may make the error several times too large. n γ₀/S(0), with γ₀ the variance, is the number of [independent] numbers that the series is
 * worth; it is at most that of the slow fluctuations. With fewer than [FEWEST_INDEPENDENT] of these, or fewer than
 * [FEWEST_NUMBERS] numbers, [error] is NaN. Where most series of a kind get an error, it covers the true value in 60 to
 * 75 % of them (docs/adr/0118, and docs/validation.md for real runs).
 *
 * @property mean NaN for an empty series
 * @property error one standard error; NaN unless the average [isLevelled]
 * @property count numbers in the series
 * @property independent independent numbers that the series is worth; more than [count] where neighbours are correlated
 *   negatively; NaN where this is not known
 */
public class BlockAverage @JvmOverloads constructor(
    public val mean: Double,
    public val error: Double,
    public val count: Int,
    public val independent: Double = Double.NaN,
) {
    /** Whether there are enough independent numbers for an [error]. */
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
        /** Independent numbers below which no error is given. */
        public const val FEWEST_INDEPENDENT: Double = 8.0

        /** Length of a series below which no error is given. */
        public const val FEWEST_NUMBERS: Int = 16

        /** Scatter of a constant, in units of its size; that of its pseudovalues is larger by their number. */
        private const val ROUNDING = 1e-14

        /** Of [series], in order of time. */
        @JvmStatic
        public fun of(series: DoubleArray): BlockAverage {
            val n = series.size
            if (n == 0) return BlockAverage(Double.NaN, Double.NaN, 0, 0.0)
            return of(series, series.sum() / n, ROUNDING)
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
            return of(pseudovalues(columns, sums, whole, function), whole)
        }

        /**
         * The same for columns that in part sum up how quantities of the [state] change, such as work less dissipation.
         * Each of these has n + 1 values, before and after every number of the columns. The changes add up to that
         * from the first value to the last, so their part of the error falls as 1/n ([StateChange]).
         */
        internal fun of(columns: Array<DoubleArray>, state: Array<DoubleArray>, function: OfMeans): BlockAverage {
            val plain = of(columns, function)
            if (state.isEmpty() || !(plain.error > 0)) return plain
            val sums = DoubleArray(columns.size) { columns[it].sum() }
            val split = StateChange(pseudovalues(columns, sums, plain.mean, function), state)
            val rest = of(split.rest, plain.mean)
            return BlockAverage(plain.mean, hypot(rest.error, split.error), plain.count, rest.independent)
        }

        private fun pseudovalues(
            columns: Array<DoubleArray>,
            sums: DoubleArray,
            whole: Double,
            function: OfMeans,
        ): DoubleArray {
            val n = columns[0].size
            val means = DoubleArray(sums.size)
            return DoubleArray(n) { i ->
                for (k in sums.indices) means[k] = (sums[k] - columns[k][i]) / (n - 1)
                whole + (n - 1) * (whole - function.of(means))
            }
        }

        /** [mean], with the error of the average of the pseudovalues in [series]. */
        internal fun of(series: DoubleArray, mean: Double): BlockAverage = of(series, mean, ROUNDING * series.size)

        /** @param rounding scatter of a constant, in units of its size */
        private fun of(series: DoubleArray, mean: Double, rounding: Double): BlockAverage {
            val n = series.size
            if (n < FEWEST_NUMBERS ||
                series.any { !it.isFinite() }
            ) {
                return BlockAverage(mean, Double.NaN, n, Double.NaN)
            }
            // Around the first, so that a sum of many rounds no more than its numbers.
            val centre = series[0] + series.sumOf { it - series[0] } / n
            // In units of the largest, so that no square overflows or vanishes.
            val size = series.maxOf { abs(it - centre) }
            val scaled = DoubleArray(n) { if (size == 0.0) 0.0 else (series[it] - centre) / size }
            val scatter = sqrt(scaled.sumOf { it * it } / n)
            if (size * scatter <= rounding * abs(mean)) return BlockAverage(mean, 0.0, n, n.toDouble())
            val (square, independent) = LowFrequencies.squaredError(scaled)
            if (independent < FEWEST_INDEPENDENT) return BlockAverage(mean, Double.NaN, n, independent)
            return BlockAverage(mean, size * sqrt(square), n, independent)
        }
    }
}

/** A function of the means of columns, given in the order of the columns. */
public fun interface OfMeans {
    /** The number for [means]; the array is used again. */
    public fun of(means: DoubleArray): Double
}
