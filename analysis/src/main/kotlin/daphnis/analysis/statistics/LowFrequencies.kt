package daphnis.analysis.statistics

import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.sin

/**
 * The spectrum of a series at its lowest frequencies, 1 to [FREQUENCIES] periods in the length of the series, and what
 * it extrapolates to at frequency 0. There the spectrum is n times the squared error of the mean (Heidelberger & Welch
 * 1981, Comm. ACM 24, 233). It is fitted by maximum likelihood, each ordinate being exponential around the spectrum
 * (Whittle 1953, Ark. Mat. 2, 423), by one of two curves with a corner, if one is likelier than a constant:
 *
 * - S(0) / (1 + (j/c)²): fluctuations that are forgotten in n/(2πc) numbers;
 * - S(0) (1 + (j/c)²): what one number adds others take away again.
 *
 * An oscillation of some more than [FREQUENCIES] periods leaks into the highest of them, which looks like the second. So
 * where that is chosen S(0) is the larger one of it and of what the lower half of the ordinates gives by itself.
 *
 * @property atZero S(0), in the squared unit of the series
 * @property independent numbers that are independent by the first curve, π c; infinite for the others
 */
internal class LowFrequencies private constructor(val atZero: Double, val independent: Double) {
    companion object {
        /** More of them are surer of the level, fewer are surer not to see past a corner: chosen by coverage. */
        const val FREQUENCIES = 12

        /** Corners that are tried, from a quarter of the lowest frequency to ten times the highest. */
        private val CORNERS = DoubleArray(64) { FREQUENCIES * exp(ln(0.02) + it * ln(500.0) / 63) }

        /**
         * How much likelier than a flat spectrum a curve must be, as a logarithm. More where it rises: one ordinate that
         * is low by chance would make an error far too small.
         */
        private const val FALLING = 0.5
        private const val RISING = 2.0

        /** What the square of an error lacks on average, in units of itself over the independent numbers: measured. */
        private const val LACKING = 3.0

        private val BOTH = booleanArrayOf(true, false)

        /**
         * Squared standard error of the mean of [series], given around 0 or around a line as for [of], and the number
         * of independent numbers that the series is worth. Whatever cancels within it, what is cut off at its two ends
         * does not: the square is at least the variance over n².
         */
        fun squaredError(series: DoubleArray, isStraightened: Boolean = false): Pair<Double, Double> {
            val n = series.size
            val variance = series.sumOf { it * it } / (n - if (isStraightened) 2 else 1)
            val slow = of(series, isStraightened)
            val spectrum = maxOf(slow.atZero, variance / n)
            val independent = minOf(n * variance / spectrum, slow.independent)
            return spectrum / n * (1 + LACKING / independent) to independent
        }

        /**
         * Of [series] around its mean 0, of four numbers or more, or around the line that fits it best if it
         * [isStraightened]: the line has taken 6/(πj)² of one of the two parts of ordinate j. Time grows with the length
         * of the series.
         */
        fun of(series: DoubleArray, isStraightened: Boolean = false): LowFrequencies {
            val ordinates = DoubleArray(minOf(FREQUENCIES, (series.size - 1) / 2)) {
                val left = if (isStraightened) 1 - 3 / (PI * (it + 1) * PI * (it + 1)) else 1.0
                ordinate(series, it + 1) / left
            }
            val (found, rises) = fitted(ordinates)
            if (!rises) return found
            val lower = fitted(ordinates.copyOf((ordinates.size + 1) / 2)).first
            return LowFrequencies(maxOf(found.atZero, lower.atZero), found.independent)
        }

        /** The likeliest curve through [ordinates], and whether it is one that rises. */
        private fun fitted(ordinates: DoubleArray): Pair<LowFrequencies, Boolean> {
            var best = LowFrequencies(ordinates.average(), Double.POSITIVE_INFINITY)
            var rises = false
            if (best.atZero == 0.0) return best to rises
            var least = ordinates.size * ln(best.atZero)
            for (corner in CORNERS) {
                for (falls in BOTH) {
                    var shapes = 1.0
                    var level = 0.0
                    for (k in ordinates.indices) {
                        val rise = 1 + (k + 1) * (k + 1) / (corner * corner)
                        val shape = if (falls) 1 / rise else rise
                        shapes *= shape
                        level += ordinates[k] / shape / ordinates.size
                    }
                    val unlikely = ln(shapes) + ordinates.size * ln(level) + if (falls) FALLING else RISING
                    if (unlikely >= least) continue
                    least = unlikely
                    rises = !falls
                    best = LowFrequencies(level, if (falls) PI * corner else Double.POSITIVE_INFINITY)
                }
            }
            return best to rises
        }

        /** |Σ x_k exp(2πi j k/n)|²/n, by turning a pointer from number to number. */
        private fun ordinate(x: DoubleArray, j: Int): Double {
            val turn = 2 * PI * j / x.size
            val (stepX, stepY) = cos(turn) to sin(turn)
            var pointX = 1.0
            var pointY = 0.0
            var sumX = 0.0
            var sumY = 0.0
            for (value in x) {
                sumX += value * pointX
                sumY += value * pointY
                val next = pointX * stepX - pointY * stepY
                pointY = pointX * stepY + pointY * stepX
                pointX = next
            }
            return (sumX * sumX + sumY * sumY) / x.size
        }
    }
}
