package daphnis.analysis.wave

import kotlin.math.ln
import kotlin.math.sqrt

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
    private val inverse: Array<DoubleArray>,
) {
    /** The same likelihood at the given [parameters], with each error times its factor. */
    fun at(parameters: DoubleArray, factors: DoubleArray): LeastSquares =
        LeastSquares(parameters, DoubleArray(errors.size) { errors[it] * factors[it] }, likelihood, inverse)

    /** By how much each number that is left, of [rest], moves parameter [a]. */
    fun influence(a: Int, rest: DoubleArray, columns: List<DoubleArray>): DoubleArray =
        DoubleArray(rest.size) { j -> rest[j] * columns.indices.sumOf { inverse[a][it] * columns[it][j] } }

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
            return LeastSquares(parameters, DoubleArray(k) { sqrt(variance * inverted[it][it]) }, likelihood, inverted)
        }

        private fun product(a: DoubleArray, b: DoubleArray): Double {
            var sum = 0.0
            for (i in a.indices) sum += a[i] * b[i]
            return sum
        }

        /** Inverse and determinant of a positive matrix, by Gauss and Jordan; null where it is none. */
        fun inverse(a: Array<DoubleArray>): Pair<Array<DoubleArray>, Double>? {
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
