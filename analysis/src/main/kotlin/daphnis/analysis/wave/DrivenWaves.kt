package daphnis.analysis.wave

import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * Two waves, outward and inward, which grow by Landau's equation while the motion of single particles drives them:
 *
 * ```
 * b' = exp(s + iδ − q A²) b + w      A² = |b|² of both waves over its mean, w random
 * ```
 *
 * from one period to the next, each seen with white noise. Small waves wander as w drives them, large ones less, and
 * what is seen of both waves and of their phases has the same w. So the noise is known from four series at once. The
 * innovations of a Kalman filter are fitted by least squares, its gains kept from one step of Gauss and Newton to the
 * next (Harvey 1989, Forecasting, structural time series models, ch. 3). Kinds of noise, [DrivenNoise], are weighted by
 * their likelihood: a short series does not tell which it is, and they differ in their errors. Frequencies of real
 * waves also wander as their amplitudes do. So the error of δ grows by what the memory of its innovations makes it,
 * over [LAGS] periods (Newey & West 1987, Econometrica 55, 703).
 *
 * @param waves real and imaginary parts of the amplitudes by period: outward, then inward
 */
internal class DrivenWaves(private val waves: List<Array<DoubleArray>>) {
    private val n = waves[0][0].size

    /** A² from each period to the next, over its geometric mean. */
    private val squares = DoubleArray(n - 1) { (square(it) + square(it + 1)) / 2 }.also { all ->
        val mean = exp(all.sumOf { ln(it) } / all.size)
        for (k in all.indices) all[k] /= mean
    }

    private fun square(k: Int) = waves.sumOf { (re, im) -> re[k] * re[k] + im[k] * im[k] }

    /** s and δ per period with their standard errors. */
    class Found(val rate: Double, val rateError: Double, val turning: Double, val turningError: Double)

    /** Of all kinds of noise, with q where [ends]; from a guess of s and δ. Null where none fits. */
    fun fit(ends: Boolean, rate: Double, turning: Double): Found? {
        val found = DrivenNoise.ALL.mapNotNull { noise -> fit(noise, ends, rate, turning) }
        val (s, sError) = averaged(found, 0) ?: return null
        val (delta, deltaError) = averaged(found, 1) ?: return null
        return Found(s, sError, delta, deltaError)
    }

    private fun averaged(found: List<LeastSquares>, a: Int) =
        Estimate.averaged(found.map { Estimate(it.parameters[a], it.errors[a], it.likelihood) })

    /** The last step, with the parameters in place of their changes. */
    private fun fit(noise: DrivenNoise, ends: Boolean, rate: Double, turning: Double): LeastSquares? {
        var p = if (ends) doubleArrayOf(rate, turning, rate / squares.last() / 2) else doubleArrayOf(rate, turning)
        repeat(STEPS) {
            val filter = Filter(noise)
            val rest = filter.innovations(p)
            val columns = p.indices.map { a ->
                val moved = filter.innovations(p.copyOf().also { it[a] += STEP })
                DoubleArray(rest.size) { (rest[it] - moved[it]) / STEP }
            }
            val step = LeastSquares.of(rest, columns) ?: return null
            val next = DoubleArray(p.size) { p[it] + step.parameters[it] }
            if (!next.all { it.isFinite() && it < LARGEST }) return null
            val change = Math.abs(next[0] - p[0]) / step.errors[0]
            // Nothing that ends: without it.
            p = if (next.size > 2 && next[2] < 0) next.copyOf(2) else next
            if (p.size == next.size && change < ENOUGH) {
                step.likelihood -= filter.logarithms
                val factors = DoubleArray(p.size) { 1.0 }
                factors[1] = memory(step.influence(1, rest, columns))
                return step.at(p, factors)
            }
        }
        return null
    }

    /** By what factor the memory of what is left from period to period makes an error larger, or smaller by chance. */
    private fun memory(influence: DoubleArray): Double {
        val byPeriod =
            DoubleArray(n - 1) { k -> (0 until 4).sumOf { influence[2 * ((it / 2) * (n - 1) + k) + it % 2] } }
        fun lagged(l: Int) = (l until n - 1).sumOf { byPeriod[it] * byPeriod[it - l] }
        val sum = lagged(0) + 2 * (1..minOf(LAGS, n - 2)).sumOf { (1 - it / (LAGS + 1.0)) * lagged(it) }
        return sqrt(maxOf(LEAST_MEMORY, sum / lagged(0)))
    }

    /** Whitened innovations; gains are those of the first parameters asked for. */
    private inner class Filter(private val noise: DrivenNoise) {
        private val gains = DoubleArray(n)
        private val sizes = DoubleArray(n)
        private var isFixed = false

        /** Σ ln of the variances of complex innovations. */
        var logarithms = 0.0

        fun innovations(p: DoubleArray): DoubleArray {
            val rest = DoubleArray(4 * (n - 1))
            if (!isFixed) fix(p)
            for ((d, wave) in waves.withIndex()) {
                var re = wave[0][0]
                var im = wave[1][0]
                for (k in 0 until n - 1) {
                    val size = exp(rate(p, k))
                    val angle = p[1]
                    val c = size * cos(angle)
                    val s = size * sin(angle)
                    val (x, y) = c * re - s * im to c * im + s * re
                    val (ex, ey) = wave[0][k + 1] - x to wave[1][k + 1] - y
                    re = x + gains[k] * ex
                    im = y + gains[k] * ey
                    val at = 2 * (d * (n - 1) + k)
                    rest[at] = ex / sizes[k]
                    rest[at + 1] = ey / sizes[k]
                }
            }
            return rest
        }

        private fun rate(p: DoubleArray, k: Int) = if (p.size > 2) p[0] - p[2] * squares[k] else p[0]

        private fun fix(p: DoubleArray) {
            var variance = noise.seen
            logarithms = 0.0
            for (k in 0 until n - 1) {
                val before = exp(2 * rate(p, k)) * variance + noise.driving(squares[k])
                val all = before + noise.seen
                gains[k] = before / all
                variance = (1 - gains[k]) * before
                sizes[k] = sqrt(all)
                logarithms += 2 * ln(all)
            }
            isFixed = true
        }
    }

    private companion object {
        const val STEPS = 40
        const val LAGS = 4
        const val LEAST_MEMORY = 0.5
        const val STEP = 1e-5
        const val ENOUGH = 1e-3
        const val LARGEST = 50.0
    }
}

/**
 * Kinds of noise of [DrivenWaves], up to a factor.
 *
 * @property constant variance of w that does not depend on the waves
 * @property growing the part of it that grows as their squares
 * @property seen variance of the noise with which they are seen
 */
internal class DrivenNoise private constructor(
    private val constant: Double,
    private val growing: Double,
    val seen: Double,
) {
    /** Variance of w where A² over its mean is [square]. */
    fun driving(square: Double): Double = constant + growing * square

    companion object {
        private val SEEN = doubleArrayOf(0.0, 0.1, 0.3, 1.0, 3.0, 10.0)
        private val GROWING = doubleArrayOf(0.0, 0.1, 0.5, 1.0)

        /** Kinds that are tried. */
        val ALL: List<DrivenNoise> =
            SEEN.flatMap { seen -> GROWING.map { DrivenNoise(1 - it, it, seen) } } + DrivenNoise(0.0, 0.0, 1.0)
    }
}
