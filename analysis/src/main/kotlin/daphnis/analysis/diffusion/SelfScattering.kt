package daphnis.analysis.diffusion

import kotlin.math.cos
import kotlin.math.ln
import kotlin.math.pow

/**
 * How particles forget where they were: the self-intermediate scattering function F_s(k, t) = ⟨cos k·(r(t₀ + t) −
 * r(t₀))⟩ and the non-Gaussian parameter α₂(t) = d ⟨Δr⁴⟩/((d + 2) ⟨Δr²⟩²) − 1 in d dimensions (Rahman 1964, Phys. Rev.
 * 136, A405), by lag, averaged over particles and origins t₀. k has the length [waveNumber] and goes along each of the
 * coordinates of [trajectories] in turn, which must be all those of an isotropic gas: x, y and z, of discs x and y. F_s
 * is exp(−D k² t), and α₂ 0, where displacements are Gaussian.
 *
 * Lags are those of [MeanSquareDisplacement] up to half the time, each a fifth longer than the one before at least; of
 * more than [most] particles every n-th is taken. Errors are from blocks of time as long as the lag, of all particles
 * together. NaN where the time is shorter than five lags.
 *
 * The α₂ of N independent particles and one origin in d dimensions is 2/(dN) too small; of many origins less.
 *
 * @throws IllegalArgumentException for fewer than [MeanSquareDisplacement.FEWEST_TIMES] times or 2 particles
 */
public class SelfScattering @JvmOverloads constructor(
    trajectories: Trajectories,
    public val waveNumber: Double,
    most: Int = 2_000,
) {
    /** Places between the times of each lag. */
    private val steps: IntArray

    /** Lags in units of time, ascending. */
    public val lag: DoubleArray

    /** F_s by lag, and one standard error. */
    public val scattering: DoubleArray

    /** One standard error of [scattering]; NaN at lags that are too long for the time. */
    public val scatteringError: DoubleArray

    /** α₂ by lag; NaN where nothing has moved. */
    public val nonGaussian: DoubleArray

    /** One standard error of [nonGaussian]; NaN at lags that are too long for the time. */
    public val nonGaussianError: DoubleArray

    init {
        require(trajectories.size >= MeanSquareDisplacement.FEWEST_TIMES) {
            "${trajectories.size} times; there must be ${MeanSquareDisplacement.FEWEST_TIMES} at least"
        }
        require(trajectories.particles >= 2) { "one particle; there must be 2 at least" }
        require(waveNumber > 0 && waveNumber.isFinite()) { "the wave number is $waveNumber; it must be positive" }
        require(most >= 2) { "$most particles at most; there must be 2" }
        steps = Lags.upToHalf(trajectories.size)
        val every = (trajectories.particles + most - 1) / most
        val dimensions = trajectories.coordinates.size
        lag = DoubleArray(steps.size)
        scattering = DoubleArray(steps.size)
        scatteringError = DoubleArray(steps.size)
        nonGaussian = DoubleArray(steps.size)
        nonGaussianError = DoubleArray(steps.size)
        for ((l, step) in steps.withIndex()) {
            lag[l] = Lags.mean(trajectories.size, step, trajectories::time)
            val (f, two, four) = byOrigin(trajectories, step, every)
            scattering[l] = f.average()
            scatteringError[l] = OverOrigins.error(f, step)
            fun parameter(square: Double, fourth: Double) =
                dimensions * fourth / ((dimensions + 2) * square * square) - 1
            nonGaussian[l] = parameter(two.average(), four.average())
            nonGaussianError[l] = OverOrigins.error(arrayOf(two, four), step) { parameter(it[0], it[1]) }
        }
    }

    /** Means over particles by origin: of cos k Δ, Δr² and Δr⁴. */
    private fun byOrigin(t: Trajectories, step: Int, every: Int): Array<DoubleArray> {
        val result = Array(3) { DoubleArray(t.size - step) }
        val axes = t.coordinates.indices
        val taken = (t.particles + every - 1) / every
        for (origin in result[0].indices) {
            var f = 0.0
            var two = 0.0
            var four = 0.0
            for (k in 0 until t.particles step every) {
                var square = 0.0
                for (axis in axes) {
                    val d = t.at(origin + step, axis)[k] - t.at(origin, axis)[k]
                    f += cos(waveNumber * d)
                    square += d * d
                }
                two += square
                four += square * square
            }
            result[0][origin] = f / (taken * t.coordinates.size)
            result[1][origin] = two / taken
            result[2][origin] = four / taken
        }
        return result
    }

    /**
     * Time in which F_s falls to 1/e, on a straight line of ln F_s over ln t between lags; NaN where it does not, or
     * has before the first lag.
     */
    public fun relaxationTime(): Double {
        val level = 1 / Math.E
        val at = scattering.indexOfFirst { it < level }
        if (at < 1 || scattering[at] <= 0) return Double.NaN
        val share = ln(scattering[at - 1] / level) / ln(scattering[at - 1] / scattering[at])
        return lag[at - 1] * (lag[at] / lag[at - 1]).pow(share)
    }
}
