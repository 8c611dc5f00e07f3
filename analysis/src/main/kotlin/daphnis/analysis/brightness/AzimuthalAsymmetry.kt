package daphnis.analysis.brightness

import daphnis.analysis.statistics.BlockAverage
import kotlin.math.PI
import kotlin.math.hypot

/**
 * How the brightness of a ring depends on the azimuth at which the eye stands, as its wakes make it: twice in a turn.
 * From the even harmonics of the mean over the states, the second and, from five azimuths in half a turn on, the
 * fourth. Errors are those of the jackknife pseudovalues over the states.
 *
 * @property amplitude (largest − smallest)/mean of these harmonics, which noise alone has, too
 * @property minimum azimuth of the smallest less a quarter of a turn, in radians, in [−π/2, π/2). From a particle at an
 *   ansa the eye stands at the azimuth of a quarter of a turn, which becomes smaller as the particle moves on: so it is
 *   how far before the ansae, in the direction of motion, a ring is darkest
 * @property isSeen whether the second harmonic is four of its errors away from 0; if not, [minimum] means nothing
 */
public class AzimuthalAsymmetry private constructor(
    public val amplitude: BlockAverage,
    public val minimum: BlockAverage,
    public val isSeen: Boolean,
) {
    public companion object {
        private const val SIGNIFICANT = 4.0
        private const val FEWEST = 6
        private const val FEWEST_OF_FOURTH = 10
        private const val PLACES = 720
        private const val REFINEMENTS = 40
        private const val ROUNDING = 1e-9

        /**
         * Of [brightness], for each of as many azimuths, evenly over a whole turn from 0 on, a series over the states
         * in order of time.
         *
         * @return null for fewer than six azimuths or an odd number, no state, or no light
         */
        @JvmStatic
        public fun of(brightness: Array<DoubleArray>): AzimuthalAsymmetry? {
            val n = brightness.size
            if (n < FEWEST || n % 2 != 0 || brightness[0].isEmpty()) return null
            val means = DoubleArray(n) { brightness[it].average() }
            if (!(means.sum() > 0)) return null
            val whole = Harmonics(means)
            val amplitude = BlockAverage.of(brightness) { Harmonics(it).amplitude }
            val minimum = BlockAverage.of(brightness) {
                whole.minimum + folded(Harmonics(it).minimum - whole.minimum)
            }
            // Seen from straight above all azimuths are one.
            return AzimuthalAsymmetry(amplitude, minimum, amplitude.mean > ROUNDING && isSeen(brightness))
        }

        private fun isSeen(brightness: Array<DoubleArray>): Boolean {
            val even = BlockAverage.of(brightness) { Harmonics(it).even(2) }
            val odd = BlockAverage.of(brightness) { Harmonics(it).odd(2) }
            return hypot(even.mean / even.error, odd.mean / odd.error) > SIGNIFICANT
        }

        private fun folded(angle: Double) = angle - PI * Math.floor(angle / PI + 0.5)
    }

    /** The even harmonics of [values], at azimuths that are evenly spread over a turn. */
    private class Harmonics(private val values: DoubleArray) {
        private val n = values.size
        private val mean = values.average()
        private val orders = if (n < FEWEST_OF_FOURTH) intArrayOf(2) else intArrayOf(2, 4)
        private val cosines = DoubleArray(orders.size) { even(orders[it]) }
        private val sines = DoubleArray(orders.size) { odd(orders[it]) }
        private val places = DoubleArray(PLACES) { value(PI * it / PLACES) }

        fun even(order: Int) = 2.0 / n * values.indices.sumOf { values[it] * StrictMath.cos(2 * PI * order * it / n) }

        fun odd(order: Int) = 2.0 / n * values.indices.sumOf { values[it] * StrictMath.sin(2 * PI * order * it / n) }

        private fun value(azimuth: Double) = orders.indices.sumOf {
            cosines[it] * StrictMath.cos(orders[it] * azimuth) + sines[it] * StrictMath.sin(orders[it] * azimuth)
        }

        val amplitude: Double get() = (value(lowest(-1)) - value(lowest(1))) / mean

        val minimum: Double get() = folded(lowest(1) - PI / 2)

        /** The azimuth at which [sign] times the harmonics are least, by thirds around the lowest of many places. */
        private fun lowest(sign: Int): Double {
            val nearest = places.indices.minByOrNull { sign * places[it] }!!
            var from = PI * (nearest - 1) / PLACES
            var to = PI * (nearest + 1) / PLACES
            repeat(REFINEMENTS) {
                val third = (to - from) / 3
                if (sign * value(from + third) < sign * value(to - third)) to -= third else from += third
            }
            return (from + to) / 2
        }
    }
}
