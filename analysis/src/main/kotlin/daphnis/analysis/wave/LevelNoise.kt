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
        fun likeliest(logarithms: DoubleArray, fit: (LevelNoise) -> LeastSquares?): LeastSquares? =
            relatives(logarithms).flatMap { relative -> WALKS.map { LevelNoise(it, relative) } }.mapNotNull(fit)
                .maxByOrNull { it.likelihood }
    }
}
