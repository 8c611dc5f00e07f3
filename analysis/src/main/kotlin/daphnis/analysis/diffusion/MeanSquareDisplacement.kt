package daphnis.analysis.diffusion

import daphnis.analysis.statistics.BlockAverage
import kotlin.math.abs

/**
 * A coefficient of self-diffusion, and the lags over which it was fitted.
 *
 * @property value in length²/time; [error] one standard error, NaN where the time is too short to know it
 * @property from shortest lag of the fit, [to] the longest
 */
public class Diffusion(
    public val value: Double,
    public val error: Double,
    public val from: Double,
    public val to: Double,
)

/**
 * Mean square displacements ⟨(x(t₀ + t) − x(t₀))²⟩ of [trajectories] by lag t, averaged over particles and over all
 * origins t₀, for lags up to half the covered time. Their slope over 2 is the coefficient of self-diffusion D once it
 * no longer changes (Einstein 1905, Ann. Phys. 322, 549; Frenkel & Smit, Understanding Molecular Simulation, ch. 4.4).
 *
 * Errors are those of averages over time: the mean over all particles, by origin, is a series, whose blocks of at least
 * a lag's length go through [BlockAverage]. So particles need not be independent of one another, and in wakes they are
 * not; what is taken as independent is the motion at times far apart, beyond the measured correlation. The time must be
 * about sixteen times the lag, or an error is NaN.
 *
 * @throws IllegalArgumentException for fewer than [FEWEST_TIMES] times or 2 particles
 */
public class MeanSquareDisplacement(trajectories: Trajectories) {
    /** Lags in units of time, ascending: the mean over origins, in case times are not evenly spread. */
    public val lag: DoubleArray

    /** `[coordinate][lag][origin]`, the mean over all particles. */
    private val square: Array<Array<DoubleArray>>

    init {
        require(trajectories.size >= FEWEST_TIMES) {
            "${trajectories.size} times; there must be $FEWEST_TIMES at least"
        }
        require(trajectories.particles >= 2) { "one particle; there must be 2 at least" }
        val lags = trajectories.size / LAG_PART
        lag = DoubleArray(lags) { l ->
            (0 until trajectories.size - l - 1).sumOf { trajectories.time(it + l + 1) - trajectories.time(it) } /
                (trajectories.size - l - 1)
        }
        square = Array(trajectories.coordinates.size) { c -> Array(lags) { l -> byOrigin(trajectories, c, l) } }
    }

    private fun byOrigin(t: Trajectories, coordinate: Int, l: Int) = DoubleArray(t.size - l - 1) { origin ->
        val from = t.at(origin, coordinate)
        val to = t.at(origin + l + 1, coordinate)
        var sum = 0.0
        for (k in from.indices) sum += (to[k] - from[k]) * (to[k] - from[k])
        sum / from.size
    }

    /** Mean square displacement along [coordinate] by lag, in length². */
    public fun mean(coordinate: Int): DoubleArray = DoubleArray(lag.size) { square[coordinate][it].average() }

    /** One standard error of [mean]; NaN at lags that are too long for the time. */
    public fun error(coordinate: Int): DoubleArray =
        DoubleArray(lag.size) { l -> OverOrigins.error(square[coordinate][l], l + 1) }

    /**
     * D of the mean over [coordinates]: half the slope, each lag weighted by 1/lag², from where the displacement has
     * become linear in time; up to four times that lag, but not beyond a sixteenth of the time if it is twice that lag
     * at least. Longer lags add noise and no knowledge. Null if it is not linear within the available lags.
     *
     * @param from shortest lag of the fit, such as that found for the mean of more coordinates; null to find it
     * @param least no fit that is found begins before this lag, such as one period of what swings
     */
    @JvmOverloads
    public fun diffusion(vararg coordinates: Int, from: Double? = null, least: Double = 0.0): Diffusion? {
        require(coordinates.isNotEmpty()) { "no coordinate" }
        val mean = Array(lag.size) { l ->
            DoubleArray(square[0][l].size) { o -> coordinates.sumOf { square[it][l][o] } / coordinates.size }
        }
        val first = if (from == null) linearFrom(mean, least) else lag.indexOfFirst { it >= from }
        if (first < 0) return null
        val last = last(first)
        if (last >= lag.size || last - first + 1 < FEWEST_LAGS) return null
        val slopes = slopes(mean, first, last).also { for (k in it.indices) it[k] /= 2.0 }
        return Diffusion(slopes.average(), OverOrigins.error(slopes, last + 1), lag[first], lag[last])
    }

    /** The last lag of a fit that begins with lag [first]. */
    private fun last(first: Int): Int {
        val shortest = first + 1
        val most = square[0][0].size / LAGS_IN_TIME
        return most.coerceIn(2 * shortest, 4 * shortest).coerceAtMost(maxOf(lag.size, 2 * shortest)) - 1
    }

    /**
     * The lag 2t of the first t for which the slope from t to 2t equals that from 2t to 4t: within 5 %, or within two
     * standard errors where these are larger, up to 20 %. Memory that remains at t has died out at 2t. Ballistic flight
     * never passes, because its slope doubles with the lag. Not before the lag [least]. −1 for none.
     */
    private fun linearFrom(mean: Array<DoubleArray>, least: Double): Int {
        var t = 1
        while (2 * t <= lag.size && lag[2 * t - 1] < least * (1 - ROUNDING)) t++
        while (4 * t <= lag.size) {
            val late = rise(mean, 2 * t, 4 * t)
            val early = rise(mean, t, 2 * t)
            val slope = late.average()
            val difference = DoubleArray(late.size) { late[it] - early[it] }
            val allowed =
                maxOf(SAME_SLOPE * slope, minOf(2 * OverOrigins.scatter(difference, 4 * t), MOST_NOISE * slope))
            if (slope > 0 && abs(difference.average()) <= allowed) return 2 * t - 1
            t++
        }
        return -1
    }

    /** By origin, those that both lags have. */
    private fun rise(mean: Array<DoubleArray>, from: Int, to: Int) = DoubleArray(mean[to - 1].size) {
        (mean[to - 1][it] - mean[from - 1][it]) / (lag[to - 1] - lag[from - 1])
    }

    /** The slope over the lags [first] to [last] by origin; linear in the squares. */
    private fun slopes(mean: Array<DoubleArray>, first: Int, last: Int): DoubleArray {
        val weight = DoubleArray(last + 1) { if (it < first) 0.0 else 1 / (lag[it] * lag[it]) }
        val centre = (first..last).sumOf { weight[it] * lag[it] } / weight.sum()
        val square = (first..last).sumOf { weight[it] * (lag[it] - centre) * (lag[it] - centre) }
        return DoubleArray(mean[last].size) { origin ->
            (first..last).sumOf { weight[it] * (lag[it] - centre) * mean[it][origin] } / square
        }
    }

    public companion object {
        /** Least number of times: the slope is compared at four lags. */
        public const val FEWEST_TIMES: Int = 16

        /** Lags in the time below which no error is given; Student's t of five numbers is within ±1 in 63 %. */
        public const val FEWEST_WINDOWS: Int = 5

        private const val LAG_PART = 2
        private const val FEWEST_LAGS = 3
        private const val LAGS_IN_TIME = 16
        private const val SAME_SLOPE = 0.05
        private const val ROUNDING = 1e-9
        private const val MOST_NOISE = 0.2
    }
}
