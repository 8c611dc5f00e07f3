package daphnis.analysis.moonlet

import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.sqrt

/**
 * Drift and diffusion of a coordinate that walks at random, such as the guiding centre of a moonlet, from its change
 * over consecutive times of equal length:
 *
 * ```
 *   v = Σ ΔX / Σ Δt,   D = Σ (ΔX − v Δt)²/(2 Σ Δt) · n/(n − 1)
 * ```
 *
 * Changes over times that are much longer than the memory of what pushes are independent and, as sums of many pushes,
 * Gaussian. So D is known to √(2/(n − 1)) of itself for n times of every walker, and v to √(2D/T). Errors are NaN for
 * fewer than [FEWEST] times of all walkers together. Of several walkers D is that of all, each around its own drift.
 *
 * @property drift v of all walkers on average, length/time
 * @property driftError one standard error
 * @property diffusion D, length²/time
 * @property diffusionError one standard error
 * @property times n, of all walkers
 * @property length of each
 * @property correlation of one change with the next: where it is not 0 within √(1/n), [diffusion] is that of a time too
 *   short. Below 0 what was pushed away comes back.
 */
public class RandomWalk private constructor(
    public val drift: Double,
    public val driftError: Double,
    public val diffusion: Double,
    public val diffusionError: Double,
    public val times: Int,
    public val length: Double,
    public val correlation: Double,
) {
    /** Whether changes look independent of one another. */
    public val isSettled: Boolean get() = !(abs(correlation) * sqrt(times.toDouble()) > FAR)

    /** Root mean square of the walk in [duration] without the drift, √(2 D t); length. */
    public fun amplitude(duration: Double): Double = sqrt(2 * diffusion * duration)

    /** One standard error of [amplitude]. */
    public fun amplitudeError(duration: Double): Double = amplitude(duration) * diffusionError / (2 * diffusion)

    public companion object {
        /** Times below which there are no errors. */
        public const val FEWEST: Int = 8

        /** Standard errors beyond which a correlation is none by chance. */
        private const val FAR = 1.5

        /**
         * Over times of [shortest], or twice, four times … as long, until changes look independent of one another
         * ([isSettled]), or there are fewer than [FEWEST] times. Errors are NaN where they never do.
         *
         * @throws IllegalArgumentException as [of]
         */
        @JvmStatic
        public fun settled(time: List<DoubleArray>, x: List<DoubleArray>, shortest: Double): RandomWalk {
            var walk = of(time, x, shortest)
            while (!walk.isSettled && walk.times >= 2 * FEWEST) walk = of(time, x, 2 * walk.length)
            if (walk.isSettled) return walk
            val d = walk.diffusion
            return RandomWalk(walk.drift, Double.NaN, d, Double.NaN, walk.times, walk.length, walk.correlation)
        }

        /**
         * Of walkers with the coordinates [x], each at its own [time], ascending.
         *
         * @param length of the times over which changes are taken: longer than what pushes remembers
         * @throws IllegalArgumentException when there is no whole such time of at least two in any walker
         */
        @JvmStatic
        public fun of(time: List<DoubleArray>, x: List<DoubleArray>, length: Double): RandomWalk {
            require(time.size == x.size) { "${time.size} series of times for ${x.size} walkers" }
            require(length > 0 && length.isFinite()) { "length is $length; it must be > 0" }
            var changes = 0
            var walkers = 0
            var square = 0.0
            var product = 0.0
            var way = 0.0
            var duration = 0.0
            for (k in x.indices) {
                val ends = ends(time[k], length)
                if (ends.size < 3) continue
                val first = ends.first()
                val last = ends.last()
                val v = (x[k][last] - x[k][first]) / (time[k][last] - time[k][first])
                var before = 0.0
                for (j in 1 until ends.size) {
                    val rest = x[k][ends[j]] - x[k][ends[j - 1]] - v * (time[k][ends[j]] - time[k][ends[j - 1]])
                    square += rest * rest
                    product += before * rest
                    before = rest
                }
                changes += ends.size - 1
                walkers++
                way += x[k][last] - x[k][first]
                duration += time[k][last] - time[k][first]
            }
            require(walkers > 0) { "no walker is followed over two times of $length" }
            val freedom = changes - walkers
            val d = square / (2 * duration) * changes / freedom
            val known = if (changes >= FEWEST) 1.0 else Double.NaN
            return RandomWalk(
                way / duration,
                known * sqrt(2 * d / duration),
                d,
                known * d * sqrt(2.0 / freedom),
                changes,
                length,
                if (square > 0) product / square else 0.0,
            )
        }

        /** Rows that lie [length] apart, or as much more as rows are, and are as many as there is room for. */
        private fun ends(time: DoubleArray, length: Double): List<Int> {
            if (time.isEmpty()) return emptyList()
            val count = floor((time.last() - time[0]) / length * (1 + ROUNDING)).toInt()
            val ends = ArrayList<Int>()
            var row = 0
            for (j in 0..count) {
                val due = time.last() - (count - j) * length
                while (row < time.size - 1 && time[row] < due - ROUNDING * length) row++
                if (ends.isEmpty() || row > ends.last()) ends += row
            }
            return ends
        }

        private const val ROUNDING = 1e-9
    }
}
