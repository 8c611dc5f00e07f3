package daphnis.analysis.diffusion

import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.statistics.OfMeans
import kotlin.math.abs
import kotlin.math.ln

/**
 * How particles forget their velocity: C(t) = ⟨v(t₀)·v(t₀ + t)⟩ by lag, averaged over particles and origins t₀, the sum
 * over all coordinates of the trajectories, which are [Coordinate.Velocity]. C(0) is ⟨v²⟩. Its integral over the number
 * of coordinates is the coefficient of self-diffusion (Green 1954, J. Chem. Phys. 22, 398; Kubo 1957, J. Phys. Soc. Jpn.
 * 12, 570). Of equal elastic spheres that meet ν times in a unit of time, in d dimensions, C′(0)/C(0) = −2ν/d at every
 * density: an impact takes v_n² from the sum of v·Δv over both, and ⟨v_n²⟩ is 4⟨c²⟩/d.
 *
 * Lags are from 0 on, one state further each, up to half the time and to [longest]. States must be evenly spread in
 * time, and close together: what integrals and slopes need says [isFine].
 *
 * Errors are from blocks of time as long as the lag, of all particles together, as those of [MeanSquareDisplacement].
 * NaN where the time is shorter than five lags.
 *
 * @param longest no lag is longer, in units of time
 * @throws IllegalArgumentException for fewer than [MeanSquareDisplacement.FEWEST_TIMES] times, 2 particles, or for times
 *   that are not evenly spread
 */
public class VelocityAutocorrelation @JvmOverloads constructor(
    velocities: Trajectories,
    longest: Double = Double.POSITIVE_INFINITY,
) {
    private val dimensions = velocities.coordinates.size

    /** Time between two states. */
    public val step: Double

    /** Lags in units of time, ascending, the first of them 0. */
    public val lag: DoubleArray

    /** `[lag][origin]`, means over all particles. */
    private val byOrigin: Array<DoubleArray>

    init {
        require(velocities.size >= MeanSquareDisplacement.FEWEST_TIMES) {
            "${velocities.size} times; there must be ${MeanSquareDisplacement.FEWEST_TIMES} at least"
        }
        require(velocities.particles >= 2) { "one particle; there must be 2 at least" }
        val last = velocities.size - 1
        step = (velocities.time(last) - velocities.time(0)) / last
        for (k in 0 until last) {
            val apart = velocities.time(k + 1) - velocities.time(k)
            require(abs(apart - step) <= UNEVEN * step) { "states are $apart apart and not $step as others are" }
        }
        val wanted = minOf((velocities.size / 2).toDouble(), longest / step * (1 + ROUNDING)).toInt() + 1
        // The integral over one step is that of the cubic through four lags.
        val lags = maxOf(wanted, SMALL[1].size)
        byOrigin = Array(lags) { l -> DoubleArray(velocities.size - l) { product(velocities, it, it + l) } }
        lag = DoubleArray(lags) { it * step }
    }

    private fun product(v: Trajectories, first: Int, second: Int): Double {
        var sum = 0.0
        for (axis in 0 until dimensions) {
            val a = v.at(first, axis)
            val b = v.at(second, axis)
            for (k in a.indices) sum += a[k] * b[k]
        }
        return sum / v.particles
    }

    /** C by lag, in length²/time². */
    public val correlation: DoubleArray = DoubleArray(lag.size) { byOrigin[it].average() }

    /** C(t)/C(0) by lag. */
    public val normalised: DoubleArray = DoubleArray(lag.size) { correlation[it] / correlation[0] }

    /** One standard error of [normalised]; 0 at the lag 0, NaN at lags that are too long for the time. */
    public fun normalisedError(): DoubleArray = DoubleArray(lag.size) { l ->
        if (l ==
            0
        ) {
            0.0
        } else {
            OverOrigins.error(arrayOf(byOrigin[l], byOrigin[0].copyOf(byOrigin[l].size)), l, function = RATIO)
        }
    }

    /**
     * Whether states are so close together that C is known between them: it has fallen to no less than 0.6 of its
     * value at 0 from one to the next.
     */
    public val isFine: Boolean get() = lag.size > 1 && normalised[1] >= LEAST_OF_NEXT

    /** ∫C over the number of coordinates, from 0 to each lag: D once it no longer changes. In length²/time. */
    public fun integral(): DoubleArray = DoubleArray(lag.size) { integrals(it).average() }

    /** One standard error of [integral]; NaN at lags that are too long for the time. */
    public fun integralError(): DoubleArray =
        DoubleArray(lag.size) { if (it == 0) 0.0 else OverOrigins.error(integrals(it), it) }

    /** The integral from 0 to lag [l] by origin. */
    private fun integrals(l: Int) = weighted(DoubleArray(maxOf(l + 1, SMALL[1].size)).also { addIntegral(it, l, 1.0) })

    /** Σ [weights] · C by origin, of those that all the lags have. */
    private fun weighted(weights: DoubleArray): DoubleArray {
        val most = weights.size - 1
        return DoubleArray(byOrigin[most].size) { origin ->
            var sum = 0.0
            for (k in 0..most) sum += weights[k] * byOrigin[k][origin]
            sum
        }
    }

    /**
     * Adds to [weights] those of [factor] times the integral from 0 to lag [l]: that of the cubics through four
     * neighbours each. There is a corner at 0, so none reaches beyond it.
     */
    private fun addIntegral(weights: DoubleArray, l: Int, factor: Double) {
        val unit = factor * step / dimensions
        if (l < SMALL.size) {
            for (k in SMALL[l].indices) weights[k] += unit * SMALL[l][k]
            return
        }
        for (k in 0..l) {
            weights[k] +=
                unit * (
                    if (k < ENDS.size) {
                        ENDS[k]
                    } else if (l - k < ENDS.size) {
                        ENDS[l - k]
                    } else {
                        1.0
                    }
                    )
        }
    }

    /**
     * D by the integral of C: the mean of [integral] over lags [from] to [to], such as those of a fit of displacements,
     * with the weight that each has in that fit (slope by least squares, lags weighted by 1/lag²). Null unless states
     * are close together ([isFine]) and lags go so far, or where there are fewer than three between.
     */
    public fun diffusion(from: Double, to: Double): Diffusion? {
        val first = lag.indexOfFirst { it >= from * (1 - ROUNDING) }
        val last = lag.indexOfLast { it <= to * (1 + ROUNDING) }
        val isLong = to <= lag.last() * (1 + ROUNDING) && last - first >= FEWEST_BETWEEN && first > 0
        if (!isFine || !isLong) return null
        // The slope is Σ w (t − t̄) M(t) over its norm, and M between two lags rises by 2 D of these.
        val weight = DoubleArray(last + 1) { if (it < first) 0.0 else 1 / (lag[it] * lag[it]) }
        val centre = (first..last).sumOf { weight[it] * lag[it] } / weight.sum()
        val norm = (first..last).sumOf { weight[it] * (lag[it] - centre) * (lag[it] - centre) }
        val weights = DoubleArray(last + 1)
        var behind = 0.0
        for (l in last downTo first + 1) {
            behind += weight[l] * (lag[l] - centre)
            for (end in l - 1..l) addIntegral(weights, end, behind * step / norm / 2)
        }
        val series = weighted(weights)
        return Diffusion(series.average(), OverOrigins.error(series, last), lag[first], lag[last])
    }

    /**
     * C′(0)/C(0), in 1/time: ln(C(t)/C(0))/t at the lag 0, of the parabola in t that fits it best over the lags in which
     * C falls to [REACH], twelve of them at most. Null where fewer than three are that short.
     */
    public fun slope(): BlockAverage? {
        val reach = normalised.indexOfFirst { it < REACH }.let { if (it < 0) lag.size else it } - 1
        val most = minOf(reach, MOST_OF_SLOPE)
        if (most < FEWEST_OF_SLOPE) return null
        val weights = atZero(DoubleArray(most) { lag[it + 1] })
        val origins = byOrigin[most].size
        val columns = Array(most + 1) { byOrigin[it].copyOf(origins) }
        fun slope(c: DoubleArray) = (1..most).sumOf { weights[it - 1] * ln(c[it] / c[0]) / lag[it] }
        val value = slope(DoubleArray(most + 1) { columns[it].average() })
        return BlockAverage(value, OverOrigins.error(columns, most, LEAST_ERROR) { slope(it) }, origins)
    }

    /** Weights of values at [x] that make the value at 0 of the parabola of least squares. */
    private fun atZero(x: DoubleArray): DoubleArray {
        val size = x.last()
        fun moment(n: Int) = x.sumOf { Math.pow(it / size, n.toDouble()) }
        val m = DoubleArray(5) { moment(it) }
        val one = m[2] * m[4] - m[3] * m[3]
        val two = m[1] * m[4] - m[2] * m[3]
        val three = m[1] * m[3] - m[2] * m[2]
        val all = m[0] * one - m[1] * two + m[2] * three
        return DoubleArray(x.size) { (x[it] / size).let { u -> (one - two * u + three * u * u) / all } }
    }

    public companion object {
        /** Part of C(0) to which C may fall over the lags of [slope]. */
        public const val REACH: Double = 0.5

        private const val LEAST_OF_NEXT = 0.6
        private const val FEWEST_OF_SLOPE = 3
        private const val MOST_OF_SLOPE = 12
        private const val FEWEST_BETWEEN = 2

        /** Of the error of a slope by collisions that are independent of one another. */
        private const val LEAST_ERROR = 0.5
        private const val ROUNDING = 1e-9
        private const val UNEVEN = 0.01
        private val RATIO = OfMeans { it[0] / it[1] }

        /** Weights of the integral over few steps, by their number: of the polynomial through these, four at least. */
        private val SMALL = arrayOf(
            doubleArrayOf(0.0),
            doubleArrayOf(9.0 / 24, 19.0 / 24, -5.0 / 24, 1.0 / 24),
            doubleArrayOf(1.0 / 3, 4.0 / 3, 1.0 / 3),
            doubleArrayOf(3.0 / 8, 9.0 / 8, 9.0 / 8, 3.0 / 8),
            doubleArrayOf(1.0 / 3, 4.0 / 3, 2.0 / 3, 4.0 / 3, 1.0 / 3),
        )

        /** Of many steps, at both ends: Gregory's to third differences. */
        private val ENDS = doubleArrayOf(3.0 / 8, 7.0 / 6, 23.0 / 24)
    }
}
