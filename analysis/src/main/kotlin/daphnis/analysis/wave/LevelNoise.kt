package daphnis.analysis.wave

import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.sqrt

/**
 * Noise of a series as of a level that walks at random and is seen with white noise on it, in proportions that the
 * series itself tells by restricted likelihood (Harvey 1989, Forecasting, structural time series models, ch. 4). The
 * amplitude of both may follow [relative] sizes, as where the noise stays while the signal grows.
 *
 * @property walk variance of a step of the walk over that of the white noise; infinite for a walk alone
 * @property relative standard deviation of the noise at each number, up to a factor
 */
internal class LevelNoise(private val walk: Double, private val relative: DoubleArray) {
    /** Σ ln of the variances of what is whitened. */
    private var logarithms = 0.0

    /** [column] as a series of independent numbers of equal variance, by a Kalman filter. */
    private fun whitened(column: DoubleArray): DoubleArray {
        var level = 0.0
        var variance = 0.0
        logarithms = 0.0
        val isSeen = walk.isInfinite()
        return DoubleArray(column.size) { j ->
            val square = relative[j] * relative[j]
            variance += if (isSeen) square else walk * square
            val all = if (isSeen) variance else variance + square
            val gain = variance / all
            val rest = column[j] - level
            level += gain * rest
            variance -= gain * variance
            logarithms += ln(all)
            rest / sqrt(all)
        }
    }

    /**
     * Generalised least squares of a function with parameters p; [columns] are its derivatives by these, and [rest] is
     * what it leaves.
     */
    fun step(rest: DoubleArray, columns: List<DoubleArray>): LeastSquares? =
        LeastSquares.of(whitened(rest), columns.map { whitened(it) })?.also { it.likelihood -= logarithms / 2 }

    companion object {
        /** Proportions that are tried. */
        val WALKS = doubleArrayOf(0.0, 0.03, 0.1, 0.3, 1.0, 3.0, Double.POSITIVE_INFINITY)

        /** Whether noise stays as it is, as a series of logarithms or phases sees it, or falls as the signal grows. */
        fun relatives(logarithms: DoubleArray): List<DoubleArray> = logarithms.average().let { mean ->
            listOf(DoubleArray(logarithms.size) { 1.0 }, DoubleArray(logarithms.size) { exp(mean - logarithms[it]) })
        }

        /** The likeliest noise for the [fit] that it gives, null where none fits. */
        fun <T : Any> likeliest(logarithms: DoubleArray, fit: (LevelNoise) -> Pair<T, LeastSquares>?): T? {
            var best: Pair<T, LeastSquares>? = null
            for (relative in relatives(logarithms)) {
                for (walk in WALKS) {
                    val found = fit(LevelNoise(walk, relative)) ?: continue
                    if (best == null || found.second.likelihood > best.second.likelihood) best = found
                }
            }
            return best?.first
        }
    }
}

/**
 * Least squares by normal equations.
 *
 * @property parameters that leave the least squares
 * @property errors standard errors of these
 * @property likelihood logarithm of the restricted likelihood, up to a constant
 */
internal class LeastSquares private constructor(
    val parameters: DoubleArray,
    val errors: DoubleArray,
    var likelihood: Double,
) {
    companion object {
        /** Of independent numbers [y] of equal variance and [columns]; null where these do not tell the parameters. */
        fun of(y: DoubleArray, columns: List<DoubleArray>): LeastSquares? {
            val k = columns.size
            val n = y.size
            if (n <= k) return null
            val (inverted, determinant) = inverse(
                Array(k) { a -> DoubleArray(k) { b -> product(columns[a], columns[b]) } },
            ) ?: return null
            val sides = DoubleArray(k) { product(columns[it], y) }
            val parameters = DoubleArray(k) { a -> product(inverted[a], sides) }
            var square = 0.0
            for (j in 0 until n) {
                var rest = y[j]
                for (a in 0 until k) rest -= parameters[a] * columns[a][j]
                square += rest * rest
            }
            val variance = square / (n - k)
            val likelihood = -((n - k) * ln(square) + ln(determinant)) / 2
            if (!likelihood.isFinite()) return null
            return LeastSquares(parameters, DoubleArray(k) { sqrt(variance * inverted[it][it]) }, likelihood)
        }

        private fun product(a: DoubleArray, b: DoubleArray): Double {
            var sum = 0.0
            for (i in a.indices) sum += a[i] * b[i]
            return sum
        }

        /** Inverse and determinant of a positive matrix, by Gauss and Jordan; null where it is none. */
        private fun inverse(a: Array<DoubleArray>): Pair<Array<DoubleArray>, Double>? {
            val k = a.size
            val inverse = Array(k) { i -> DoubleArray(k) { if (i == it) 1.0 else 0.0 } }
            var determinant = 1.0
            for (c in 0 until k) {
                val pivot = a[c][c]
                if (!(pivot > 0)) return null
                determinant *= pivot
                for (j in 0 until k) {
                    a[c][j] /= pivot
                    inverse[c][j] /= pivot
                }
                for (i in 0 until k) {
                    if (i == c) continue
                    val factor = a[i][c]
                    for (j in 0 until k) {
                        a[i][j] -= factor * a[c][j]
                        inverse[i][j] -= factor * inverse[c][j]
                    }
                }
            }
            return inverse to determinant
        }
    }
}
