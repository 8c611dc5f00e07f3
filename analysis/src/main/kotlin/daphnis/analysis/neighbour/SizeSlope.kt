package daphnis.analysis.neighbour

import kotlin.math.ln
import kotlin.math.pow

/**
 * Slope of a distribution of sizes, τ of n(s) ∝ s^−τ, from numbers of clusters in bins of sizes: that of most likelihood
 * of the discrete power law (Clauset, Shalizi & Newman 2009, SIAM Rev. 51, 661) in bins (Virkar & Clauset 2014, Ann.
 * Appl. Stat. 8, 89). So bins without a cluster count, and no wide bin is taken for its middle. Sizes from the first bin
 * to the last occur, none beyond: a system of N spheres has no cluster of more.
 */
internal object SizeSlope {
    private const val LEAST = -2.0
    private const val MOST = 12.0
    private const val HALVINGS = 48

    /** Of the numeric derivative by τ. */
    private const val STEP = 1e-3

    /** Sizes of a bin up to which they are summed one by one. */
    private const val SINGLE = 8

    /**
     * τ of [counts] clusters in bins of which the sizes are [from]`[k]` to [to]`[k]`, ascending without gaps; NaN where
     * clusters are in fewer than two bins. Takes any non-negative numbers, such as means over states.
     */
    fun of(counts: DoubleArray, from: IntArray, to: IntArray): Double {
        if (counts.count { it > 0 } < 2) return Double.NaN
        val filled = counts.indices.filter { counts[it] > 0 }
        val all = counts.sum()
        fun logLikelihood(slope: Double): Double {
            var whole = 0.0
            var sum = 0.0
            for (k in counts.indices) whole += weight(slope, from[k], to[k])
            for (k in filled) sum += counts[k] / all * ln(weight(slope, from[k], to[k]))
            return sum - ln(whole)
        }
        // An exponential family: one maximum.
        var low = LEAST
        var high = MOST
        repeat(HALVINGS) {
            val middle = (low + high) / 2
            if (logLikelihood(middle + STEP) > logLikelihood(middle - STEP)) low = middle else high = middle
        }
        return ((low + high) / 2).takeIf { it > LEAST + STEP && it < MOST - STEP } ?: Double.NaN
    }

    /** Σ s^−[slope] over the sizes [from] to [to]; of many by Euler and Maclaurin's formula for the middles. */
    private fun weight(slope: Double, from: Int, to: Int): Double {
        if (to - from < SINGLE) return (from..to).sumOf { it.toDouble().pow(-slope) }
        val a = from - 0.5
        val b = to + 0.5
        val integral = if (kotlin.math.abs(slope - 1) < 1e-9) {
            ln(b / a)
        } else {
            (b.pow(1 - slope) - a.pow(1 - slope)) / (1 - slope)
        }
        return integral + slope / 24 * (b.pow(-slope - 1) - a.pow(-slope - 1))
    }
}
