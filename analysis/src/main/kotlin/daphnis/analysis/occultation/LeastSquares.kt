package daphnis.analysis.occultation

import kotlin.math.abs

/**
 * Least squares of a curve with few parameters by damped Gauss–Newton steps (Marquardt 1963, J. SIAM 11, 431), with
 * derivatives by differences.
 *
 * @param count of residuals
 * @param fill writes the residuals of parameters, which it leaves as they are, into its second array
 */
internal class LeastSquares(private val count: Int, private val fill: (DoubleArray, DoubleArray) -> Unit) {
    /** Σ residual² of [parameters]. */
    fun squares(parameters: DoubleArray): Double = residuals(parameters).sumOf { it * it }

    private fun residuals(parameters: DoubleArray) = DoubleArray(count).also { fill(parameters, it) }

    /** The parameters of the least sum that steps downhill from [start] reach. */
    fun from(start: DoubleArray): DoubleArray {
        var best = start.copyOf()
        var here = residuals(best)
        var sum = here.sumOf { it * it }
        var damping = FIRST_DAMPING
        repeat(STEPS) {
            val slopes = Array(best.size) { k ->
                val step = DIFFERENCE * maxOf(1.0, abs(best[k]))
                val ahead = residuals(best.copyOf().also { it[k] += step })
                val behind = residuals(best.copyOf().also { it[k] -= step })
                DoubleArray(count) { (ahead[it] - behind[it]) / (2 * step) }
            }
            var isDone = true
            while (damping < MOST_DAMPING) {
                val next = step(best, here, slopes, damping) ?: return best
                val there = residuals(next)
                val nextSum = there.sumOf { it * it }
                if (nextSum < sum) {
                    isDone = sum - nextSum <= ENOUGH * sum
                    best = next
                    here = there
                    sum = nextSum
                    damping /= EASING
                    break
                }
                damping *= EASING
            }
            if (isDone) return best
        }
        return best
    }

    /** One step from [at]; null where a parameter has no effect. */
    private fun step(at: DoubleArray, here: DoubleArray, slopes: Array<DoubleArray>, damping: Double): DoubleArray? {
        val n = at.size
        val matrix = Array(n) { i ->
            DoubleArray(n + 1) { j ->
                val other = if (j < n) slopes[j] else here
                var sum = 0.0
                for (k in 0 until count) sum += slopes[i][k] * other[k]
                if (i == j) sum * (1 + damping) else sum
            }
        }
        val solution = solved(matrix) ?: return null
        return DoubleArray(n) { at[it] - solution[it] }
    }

    /** Gaussian elimination with pivots of n rows of n coefficients and a right side; null if it is singular. */
    private fun solved(rows: Array<DoubleArray>): DoubleArray? {
        val n = rows.size
        for (i in 0 until n) {
            val pivot = (i until n).maxByOrNull { abs(rows[it][i]) }!!
            rows[i] = rows[pivot].also { rows[pivot] = rows[i] }
            if (!(abs(rows[i][i]) > 0)) return null
            for (k in i + 1 until n) {
                val factor = rows[k][i] / rows[i][i]
                for (j in i..n) rows[k][j] -= factor * rows[i][j]
            }
        }
        val x = DoubleArray(n)
        for (i in n - 1 downTo 0) {
            var sum = rows[i][n]
            for (j in i + 1 until n) sum -= rows[i][j] * x[j]
            x[i] = sum / rows[i][i]
        }
        return x
    }

    private companion object {
        const val STEPS = 60
        const val FIRST_DAMPING = 1e-3
        const val MOST_DAMPING = 1e9
        const val EASING = 8.0
        const val DIFFERENCE = 1e-6
        const val ENOUGH = 1e-12
    }
}
