package daphnis.analysis.diffusion

import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A coefficient of self-diffusion, and the lags over which it was fitted.
 *
 * @property value in length²/time; [error] one standard error
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
 * Errors are from [GROUPS] groups of particles, by id, that are taken as independent. They are too small where many
 * particles move together, as in wakes.
 *
 * @throws IllegalArgumentException for fewer than [FEWEST_TIMES] times or 2 particles
 */
public class MeanSquareDisplacement(trajectories: Trajectories) {
    private val groups: Int

    /** Lags in units of time, ascending: the mean over origins, in case times are not evenly spread. */
    public val lag: DoubleArray

    /** `[coordinate][group][lag]`. */
    private val square: Array<Array<DoubleArray>>

    init {
        require(trajectories.size >= FEWEST_TIMES) {
            "${trajectories.size} times; there must be $FEWEST_TIMES at least"
        }
        require(trajectories.particles >= 2) { "one particle; there must be 2 at least" }
        val lags = trajectories.size / LAG_PART
        groups = minOf(GROUPS, trajectories.particles)
        lag =
            DoubleArray(lags) { l ->
                (0 until trajectories.size - l - 1).map {
                    trajectories.time(it + l + 1) -
                        trajectories.time(it)
                }.average()
            }
        square =
            Array(trajectories.coordinates.size) { c -> Array(groups) { g -> groupMean(trajectories, c, g, lags) } }
    }

    private fun groupMean(t: Trajectories, coordinate: Int, group: Int, lags: Int): DoubleArray {
        val first = (t.particles.toLong() * group / groups).toInt()
        val end = (t.particles.toLong() * (group + 1) / groups).toInt()
        return DoubleArray(lags) { l ->
            var sum = 0.0
            val origins = t.size - l - 1
            for (origin in 0 until origins) {
                val from = t.at(origin, coordinate)
                val to = t.at(origin + l + 1, coordinate)
                for (k in first until end) sum += (to[k] - from[k]) * (to[k] - from[k])
            }
            sum / origins / (end - first)
        }
    }

    /** Mean square displacement along [coordinate] by lag, in length². */
    public fun mean(coordinate: Int): DoubleArray = DoubleArray(lag.size) { l ->
        square[coordinate].sumOf { it[l] } /
            groups
    }

    /** One standard error of [mean]. */
    public fun error(coordinate: Int): DoubleArray =
        DoubleArray(lag.size) { l -> standardError(DoubleArray(groups) { square[coordinate][it][l] }) }

    /**
     * D of the mean over [coordinates]: half the slope, each lag weighted by 1/lag², from where the displacement has
     * become linear in time. Null if it is not linear within the available lags.
     *
     * @param from shortest lag of the fit, such as that found for the mean of more coordinates; null to find it
     */
    @JvmOverloads
    public fun diffusion(vararg coordinates: Int, from: Double? = null): Diffusion? {
        require(coordinates.isNotEmpty()) { "no coordinate" }
        val byGroup = Array(groups) { g ->
            DoubleArray(lag.size) { l ->
                coordinates.sumOf { square[it][g][l] } /
                    coordinates.size
            }
        }
        val first = if (from == null) linearFrom(byGroup) else lag.indexOfFirst { it >= from }
        if (first < 0 || lag.size - first < FEWEST_LAGS) return null
        val slopes = DoubleArray(groups) { slope(byGroup[it], first) / 2 }
        return Diffusion(slopes.average(), standardError(slopes), lag[first], lag.last())
    }

    /**
     * The lag 2t of the first t for which the slope from t to 2t equals that from 2t to 4t: within 5 %, or within two
     * standard errors where these are larger, up to 20 %. Memory that remains at t has died out at 2t. Ballistic flight
     * never passes, because its slope doubles with the lag. −1 for none.
     */
    private fun linearFrom(byGroup: Array<DoubleArray>): Int {
        var t = 1
        while (4 * t <= lag.size) {
            val early = DoubleArray(groups) { rise(byGroup[it], t, 2 * t) }
            val late = DoubleArray(groups) { rise(byGroup[it], 2 * t, 4 * t) }
            val slope = late.average()
            val noise = standardError(DoubleArray(groups) { late[it] - early[it] })
            val allowed = maxOf(SAME_SLOPE * slope, minOf(2 * noise, MOST_NOISE * slope))
            if (slope > 0 && abs(slope - early.average()) <= allowed) return 2 * t - 1
            t++
        }
        return -1
    }

    private fun rise(y: DoubleArray, from: Int, to: Int) = (y[to - 1] - y[from - 1]) / (lag[to - 1] - lag[from - 1])

    private fun slope(y: DoubleArray, first: Int): Double {
        var w = 0.0
        var wx = 0.0
        var wy = 0.0
        for (l in first until lag.size) {
            val weight = 1 / (lag[l] * lag[l])
            w += weight
            wx += weight * lag[l]
            wy += weight * y[l]
        }
        var xy = 0.0
        var xx = 0.0
        for (l in first until lag.size) {
            val weight = 1 / (lag[l] * lag[l])
            xy += weight * (lag[l] - wx / w) * (y[l] - wy / w)
            xx += weight * (lag[l] - wx / w) * (lag[l] - wx / w)
        }
        return xy / xx
    }

    private fun standardError(a: DoubleArray): Double {
        val mean = a.average()
        return sqrt(a.sumOf { (it - mean) * (it - mean) } / (a.size - 1.0) / a.size)
    }

    public companion object {
        /** Groups of particles from which errors are computed. */
        public const val GROUPS: Int = 20

        /** Least number of times: the slope is compared at four lags. */
        public const val FEWEST_TIMES: Int = 16
        private const val LAG_PART = 2
        private const val FEWEST_LAGS = 3
        private const val SAME_SLOPE = 0.05
        private const val MOST_NOISE = 0.2
    }
}
