package daphnis.analysis.statistics

import kotlin.math.sqrt

/**
 * Takes from a series what it owes to changes of a state, such as the energy: x_i = r_i + Σ_k c_k (e_k,i+1 − e_k,i),
 * with the c that leave the least squares. The changes add up to those from the first state to the last, so their part
 * of the mean has a standard error of √⟨(Δe)²⟩/n, with Δe between states far apart. That falls faster than the 1/√n of
 * what is [rest].
 *
 * @param state each quantity before the first number of the series and after every number
 */
internal class StateChange(series: DoubleArray, state: Array<DoubleArray>) {
    private val n = series.size

    /** The series without the changes. */
    val rest: DoubleArray = series.copyOf()

    /** Standard error of the part of the mean that comes from the changes. */
    val error: Double

    init {
        val whole = DoubleArray(n + 1)
        val before = ArrayList<DoubleArray>()
        for (quantity in state) {
            require(quantity.size == n + 1) { "${quantity.size} states around $n numbers; there must be ${n + 1}" }
            // Gram and Schmidt: what the quantities before do not tell.
            val own = quantity.copyOf()
            for (e in before) subtract(own, projection(changes(own), e), e)
            val size = product(changes(own), changes(own))
            if (!(size > ALIKE * product(changes(quantity), changes(quantity)))) continue
            before += own
            val c = projection(centred(rest), own)
            for (i in 0 until n) rest[i] -= c * (own[i + 1] - own[i])
            subtract(whole, -c, own)
        }
        error = sqrt(farApart(whole)) / n
    }

    private fun changes(e: DoubleArray) = DoubleArray(n) { e[it + 1] - e[it] }

    private fun centred(x: DoubleArray) = x.average().let { mean -> DoubleArray(n) { x[it] - mean } }

    private fun product(a: DoubleArray, b: DoubleArray): Double {
        var sum = 0.0
        for (i in a.indices) sum += a[i] * b[i]
        return sum
    }

    /** How much of the changes of [e] is in [x]. */
    private fun projection(x: DoubleArray, e: DoubleArray) = changes(e).let { product(x, it) / product(it, it) }

    private fun subtract(from: DoubleArray, factor: Double, e: DoubleArray) {
        for (i in from.indices) from[i] -= factor * e[i]
    }

    /** Mean square difference of values of [e] that are a third to two thirds of the series apart. */
    private fun farApart(e: DoubleArray): Double {
        var sum = 0.0
        var count = 0
        for (lag in n / 3..2 * n / 3 step maxOf(1, n / 30)) {
            for (i in lag..n) sum += (e[i] - e[i - lag]) * (e[i] - e[i - lag])
            count += n + 1 - lag
        }
        return sum / count
    }

    private companion object {
        /** Part of the square of a quantity's changes below which the others tell it. */
        const val ALIKE = 1e-12
    }
}
