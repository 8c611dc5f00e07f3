package daphnis.analysis.statistics

import kotlin.math.abs
import kotlin.math.ln
import kotlin.math.sqrt

/**
 * Whether a series in time is steady: it has no trend beyond what its own slow fluctuations produce.
 *
 * The trend is a straight line by least squares, and its error follows from the spectrum of the rest at frequency 0
 * ([LowFrequencies]), of the last six sevenths, so that a transient at the start does not pass as noise. If these are
 * not worth [BlockAverage.FEWEST_INDEPENDENT] independent numbers, they show too little of the slow fluctuations for
 * that. Then the line is fitted by generalised least squares with first-order autoregressive noise, that of the last two
 * thirds (Prais & Winsten 1954); where the noise cannot be distinguished from a random walk it is treated as one (Perron
 * & Yabu 2009, J. Econometrics 151, 56). Before, neighbours are averaged in pairs until there are fewer than 64 numbers.
 *
 * A steady series is called drifting in one case of a hundred, one that is as short as 20 correlation times in some 4
 * (docs/adr/0119). A drift is found as a rule when it is larger than 12 standard errors of the average: a line's own
 * error is 3.5 of these.
 *
 * @property change change of the fitted line from the first number to the last, in the unit of the series; NaN without
 *   a verdict
 * @property error standard error of [change]; NaN without a verdict
 * @property verdict what follows from them
 */
public class Steadiness private constructor(
    public val change: Double,
    public val error: Double,
    public val verdict: Verdict,
) {
    /** [change] over its standard error; 0 for a constant. */
    public val significance: Double get() = if (change == 0.0) 0.0 else change / error

    /**
     * The largest change, up or down, that is to be reckoned with: the true one is smaller in 95 of 100 cases. NaN
     * without a verdict.
     */
    public val largest: Double get() = abs(change) + ONE_SIDED * error

    /** The same change, called steady. */
    public fun steady(): Steadiness = Steadiness(change, error, Verdict.STEADY)

    /**
     * Whether it is drifting even as one of [judged] series: of so many that are steady, one is called so in less than
     * one case of a hundred.
     */
    public fun isDriftingAmong(judged: Int): Boolean =
        verdict == Verdict.DRIFTING && abs(change) > (SIGNIFICANT + MORE * ln(judged.toDouble()) / ln(2.0)) * error

    /** What a series says of its steadiness. */
    public enum class Verdict {
        /** No trend is visible. */
        STEADY,

        /** There is a trend, or a fluctuation as slow as the series is long. */
        DRIFTING,

        /** The series has fewer than [FEWEST] numbers, or one that is not finite. */
        TOO_SHORT,
    }

    public companion object {
        /** Length of a series below which there is no verdict. */
        public const val FEWEST: Int = 24

        private const val MOST = 64

        /** Standard errors beyond which a trend counts, and how many more for each time that the series double. */
        private const val SIGNIFICANT = 3.0
        private const val MORE = 0.75

        /** 95 % of Student's t with ten degrees of freedom, about as many as the error has. */
        private const val ONE_SIDED = 1.81

        /** One over the part at the start in which a transient may be. */
        private const val START = 7

        /** Numbers in a batch of [steadyFrom]. */
        private const val BATCH = 5

        /** Of [series], evenly spaced in time. */
        @JvmStatic
        public fun of(series: DoubleArray): Steadiness {
            if (series.size < FEWEST || series.any { !it.isFinite() }) {
                return Steadiness(Double.NaN, Double.NaN, Verdict.TOO_SHORT)
            }
            val (change, error) = bySpectrum(series) ?: byWalk(series)
            val isDrift = abs(change) > SIGNIFICANT * error
            return Steadiness(change, error, if (isDrift) Verdict.DRIFTING else Verdict.STEADY)
        }

        /** Change of the line and its error by the spectrum of the rest; null where that shows too little. */
        private fun bySpectrum(series: DoubleArray): Pair<Double, Double>? {
            val n = series.size
            val noise = residuals(series.copyOfRange(n / START, n))
            val size = noise.maxOf { abs(it) }
            if (size == 0.0) return null
            val (square, independent) =
                LowFrequencies.squaredError(DoubleArray(noise.size) { noise[it] / size }, isStraightened = true)
            if (independent < BlockAverage.FEWEST_INDEPENDENT) return null
            val rest = residuals(series)
            val change = (series[n - 1] - rest[n - 1]) - (series[0] - rest[0])
            // The variance of the change along a line through n numbers is twelve times that of their mean.
            return change to size * sqrt(12 * square * noise.size / n)
        }

        /** The same by autoregressive noise. */
        private fun byWalk(series: DoubleArray): Pair<Double, Double> {
            var y = series
            while (y.size >= MOST) y = batches(y, 2)
            val noise = residuals(y.copyOfRange(y.size / 3, y.size))
            val correlation = correlation(noise)
            val (slope, spread) = slope(y, correlation)
            return slope * (y.size - 1) to innovation(noise, correlation) * spread * (y.size - 1)
        }

        /**
         * Index from which on [series] is steady. Leaving out the numbers before it makes the error of the mean of the
         * rest smallest (MSER-5: White 1997, Simulation 69, 323; White, Cobb & Spratt 2000). At most half of the series
         * is left out; −1 if that is not enough, or for fewer than 50 numbers.
         */
        @JvmStatic
        public fun steadyFrom(series: DoubleArray): Int {
            val y = batches(series, BATCH)
            if (y.size < 2 * BATCH || series.any { !it.isFinite() }) return -1
            var best = -1
            var least = Double.POSITIVE_INFINITY
            var sum = 0.0
            var square = 0.0
            val origin = y.last()
            for (k in y.indices.reversed()) {
                val d = y[k] - origin
                sum += d
                square += d * d
                val left = y.size - k
                // A few numbers at the end may lie close together by chance.
                if (left < BATCH) continue
                val error = maxOf(0.0, square - sum * sum / left) / left / left
                if (error <= least) {
                    least = error
                    best = k
                }
            }
            return if (best > y.size / 2) -1 else best * BATCH
        }

        private fun batches(a: DoubleArray, size: Int) = DoubleArray(a.size / size) { k ->
            var sum = 0.0
            for (i in 0 until size) sum += a[k * size + i]
            sum / size
        }

        /** Residuals of [y] after a least-squares line. */
        private fun residuals(y: DoubleArray): DoubleArray {
            val middle = (y.size - 1) / 2.0
            val mean = y.average()
            var product = 0.0
            var square = 0.0
            for (k in y.indices) {
                product += (k - middle) * (y[k] - mean)
                square += (k - middle) * (k - middle)
            }
            return DoubleArray(y.size) { y[it] - mean - product / square * (it - middle) }
        }

        /**
         * Lag-1 correlation of residuals [u], corrected for its bias −(2 + 4r)/n; 1 where it cannot be distinguished
         * from 1.
         */
        private fun correlation(u: DoubleArray): Double {
            var product = 0.0
            var square = 0.0
            for (k in 1 until u.size) {
                product += u[k] * u[k - 1]
                square += u[k - 1] * u[k - 1]
            }
            if (square == 0.0) return 0.0
            val r = product / square
            val unbiased = r + (2 + 4 * r) / u.size
            return if (unbiased > 1 - 1 / sqrt(1.5 * u.size)) 1.0 else maxOf(0.0, unbiased)
        }

        /** Standard deviation of the innovations in [u]. */
        private fun innovation(u: DoubleArray, correlation: Double): Double {
            var square = 0.0
            for (k in 1 until u.size) square += (u[k] - correlation * u[k - 1]) * (u[k] - correlation * u[k - 1])
            return sqrt(square / (u.size - 3))
        }

        /** Slope of the line through [y], by index, and its standard error for innovations of deviation 1. */
        private fun slope(y: DoubleArray, correlation: Double): Pair<Double, Double> {
            if (correlation == 1.0) return (y.last() - y.first()) / (y.size - 1) to 1 / sqrt(y.size - 1.0)
            val middle = (y.size - 1) / 2.0
            val first = sqrt(1 - correlation * correlation)
            // Normal equations of the numbers minus the part that the previous number predicts.
            var ones = 0.0
            var times = 0.0
            var squares = 0.0
            var sum = 0.0
            var product = 0.0
            for (k in y.indices) {
                val one = if (k == 0) first else 1 - correlation
                val time = if (k == 0) -first * middle else k - middle - correlation * (k - 1 - middle)
                val value = if (k == 0) first * y[0] else y[k] - correlation * y[k - 1]
                ones += one * one
                times += one * time
                squares += time * time
                sum += one * value
                product += time * value
            }
            val determinant = ones * squares - times * times
            return (ones * product - times * sum) / determinant to sqrt(ones / determinant)
        }
    }
}
