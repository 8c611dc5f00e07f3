package daphnis.analysis.wave

import kotlin.math.exp
import kotlin.math.sqrt

/** A [value] with its standard [error], and the logarithm of the [likelihood] of the noise with which it was found. */
internal class Estimate(val value: Double, val error: Double, val likelihood: Double) {
    companion object {
        /** Mean of [all] by likelihood, and its standard error with what they differ; null of none. */
        fun averaged(all: List<Estimate>): Pair<Double, Double>? {
            val most = all.maxOfOrNull { it.likelihood } ?: return null
            val weights = all.map { exp(it.likelihood - most) }
            val sum = weights.sum()
            val mean = all.indices.sumOf { weights[it] * all[it].value } / sum
            val square = all.indices.sumOf {
                val off = all[it].value - mean
                weights[it] * (all[it].error * all[it].error + off * off)
            }
            return mean to sqrt(square / sum)
        }
    }
}
