package daphnis.analysis.occultation

import daphnis.analysis.statistics.BlockAverage
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * The [WakeModel] that comes nearest to the mean transmission along many lines of sight, by least squares of the
 * transmission, all lines alike. Errors are those of the jackknife pseudovalues over the states: the model is fitted
 * again without each of them. So fluctuations that the lines have in common are in them. That wakes are no bars is not.
 *
 * @property model of the mean
 * @property gapDepth τ_G; [gapOverWidth] S/W; [heightOverWidth] H/W; [pitch] in radians
 * @property misfit root mean square of what is left, as a share of all light
 * @property isSeen whether the light depends on the azimuth by more than chance makes it: the second harmonic, summed
 *   over elevations, is four of its errors away from 0. If not, the bars of the model mean nothing
 * @property isNegligible whether the bars, seen from above, cover less than [LEAST_SHARE] of the plane: then they are a
 *   weak dependence on the azimuth in the shape of bars, and their numbers mean nothing either
 */
public class WakeFit private constructor(
    public val model: WakeModel,
    public val gapDepth: BlockAverage,
    public val gapOverWidth: BlockAverage,
    public val heightOverWidth: BlockAverage,
    public val pitch: BlockAverage,
    public val misfit: Double,
    public val isSeen: Boolean,
) {
    public val isNegligible: Boolean get() = model.barShare < LEAST_SHARE

    public companion object {
        /** 1/(1 + S/W) of the fewest bars that are taken for wakes. */
        public const val LEAST_SHARE: Double = 0.03

        /**
         * Of [transmissions], for each of [lines] a series over the states in order of time.
         *
         * @return null for fewer than three azimuths or two elevations, or no state
         */
        @JvmStatic
        @JvmOverloads
        public fun of(
            lines: List<LineOfSight>,
            transmissions: Array<DoubleArray>,
            section: WakeSection = WakeSection.ELLIPSE,
        ): WakeFit? {
            require(lines.size == transmissions.size) { "${lines.size} lines, ${transmissions.size} series" }
            val azimuths = lines.map { Math.floorMod(Math.round(it.azimuth / SAME), Math.round(PI / SAME)) }
            if (azimuths.distinct().size < 3 || lines.distinctBy { it.elevation }.size < 2) return null
            val states = transmissions[0].size
            if (states == 0) return null
            val sums = DoubleArray(lines.size) { transmissions[it].sum() }
            val whole = fitted(lines, DoubleArray(lines.size) { sums[it] / states }, section)
            val pseudovalues = Array(PARAMETERS) { DoubleArray(if (states > 1) states else 0) }
            for (k in pseudovalues[0].indices) {
                val rest = DoubleArray(lines.size) { (sums[it] - transmissions[it][k]) / (states - 1) }
                val without = numbers(model(squares(lines, rest, section).from(parameters(whole)), section))
                val all = numbers(whole)
                for (n in 0 until PARAMETERS) {
                    val change = all[n] - without[n]
                    pseudovalues[n][k] = all[n] + (states - 1) * if (n == PITCH) folded(change) else change
                }
            }
            val averages = numbers(whole).mapIndexed { n, value -> BlockAverage.of(pseudovalues[n], value) }
            val left = squares(lines, DoubleArray(lines.size) { sums[it] / states }, section).squares(parameters(whole))
            return WakeFit(
                whole,
                averages[0],
                averages[1],
                averages[2],
                averages[PITCH],
                sqrt(left / lines.size),
                isSeen(lines, transmissions),
            )
        }

        /** The model nearest to [transmissions], one number for each of [lines]. */
        @JvmStatic
        @JvmOverloads
        public fun fitted(
            lines: List<LineOfSight>,
            transmissions: DoubleArray,
            section: WakeSection = WakeSection.ELLIPSE,
        ): WakeModel {
            require(lines.size == transmissions.size) { "${lines.size} lines, ${transmissions.size} numbers" }
            val squares = squares(lines, transmissions, section)
            val starts = ArrayList<DoubleArray>()
            for (pitch in 0 until 12) {
                for (height in HEIGHTS) {
                    for (share in SHARES) {
                        for (depth in DEPTHS) {
                            starts += doubleArrayOf(depth, share, height, PI * (pitch - 6) / 12)
                        }
                    }
                }
            }
            val nearest = starts.map { squares.squares(it) to it }.sortedBy { it.first }.take(CLIMBS)
            val best = nearest.map { squares.from(it.second) }
            return model(best.minByOrNull { squares.squares(it) }!!, section)
        }

        private fun squares(lines: List<LineOfSight>, transmissions: DoubleArray, section: WakeSection) =
            WakeRays(lines).let { rays ->
                LeastSquares(lines.size) { parameters, residuals ->
                    rays.light(model(parameters, section), residuals)
                    for (k in residuals.indices) residuals[k] -= transmissions[k]
                }
            }

        private fun model(p: DoubleArray, section: WakeSection) =
            WakeModel(p[0], p[1], abs(p[2]), folded(p[PITCH]), section)

        private fun parameters(m: WakeModel) = doubleArrayOf(m.gapDepth, m.barShare, m.heightOverWidth, m.pitch)

        private fun numbers(m: WakeModel) = doubleArrayOf(m.gapDepth, m.gapOverWidth, m.heightOverWidth, m.pitch)

        /** An angle of bars, which is the same half a turn on, in [−π/2, π/2). */
        private fun folded(angle: Double) = angle - PI * Math.floor(angle / PI + 0.5)

        private fun isSeen(lines: List<LineOfSight>, transmissions: Array<DoubleArray>): Boolean {
            val states = transmissions[0].size
            // Around the mean of each elevation, so that azimuths which are not evenly spread make no harmonic.
            val groups = lines.indices.groupBy { lines[it].elevation }.values
            val (even, odd) = listOf<(Double) -> Double>(::cos, ::sin).map { wave ->
                BlockAverage.of(
                    DoubleArray(states) { k ->
                        groups.sumOf { group ->
                            val mean = group.sumOf { transmissions[it][k] } / group.size
                            group.sumOf { (transmissions[it][k] - mean) * wave(2 * lines[it].azimuth) }
                        }
                    },
                )
            }
            return hypot(even.mean / even.error, odd.mean / odd.error) > SIGNIFICANT
        }

        private const val PARAMETERS = 4
        private const val PITCH = 3
        private const val CLIMBS = 4
        private const val SIGNIFICANT = 4.0

        /** Radians below which two azimuths are one. */
        private const val SAME = 1e-6
        private val HEIGHTS = doubleArrayOf(0.1, 0.3, 0.6, 1.2)
        private val SHARES = doubleArrayOf(0.15, 0.3, 0.5, 0.7)
        private val DEPTHS = doubleArrayOf(0.0, 0.15, 0.4, 1.0)
    }
}
