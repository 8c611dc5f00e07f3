package daphnis.analysis.correlation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State
import daphnis.analysis.insitu.forEachPair
import daphnis.core.boundary.BoundaryConditions
import kotlin.math.PI
import kotlin.math.sqrt

/**
 * Pair correlation: pairs at a distance over those that particles without correlation would have, by bin of distance
 * from [nearest] to [farthest]. In a box periodic along z it is the radial distribution function g(r) in space;
 * otherwise the distance is counted in the x-y plane, and g is not 0 below contact. NaN for fewer than two particles.
 * At faces without images the pairs are divided by those that the box has room for.
 *
 * Hard spheres have no pairs below contact, and the most at contact. In space, let [nearest] be the distance of
 * contact, so that no bin contains both ranges.
 *
 * @param farthest largest distance; at most half the shortest edge of the box along the axes in which distances are
 *   counted
 */
public class PairCorrelation @JvmOverloads constructor(
    public val farthest: Double,
    public val bins: Int,
    public val nearest: Double = 0.0,
) : Measure {
    init {
        require(nearest >= 0 && farthest > nearest && farthest.isFinite() && bins >= 1) {
            "$bins bins from $nearest to $farthest; there must be one at least, of a width > 0, from a distance >= 0 on"
        }
    }

    private val width = (farthest - nearest) / bins

    /** Middle of [bin]. */
    public fun centre(bin: Int): Double = nearest + (bin + 0.5) * width

    /** @throws IllegalArgumentException when the box is too small for [farthest] */
    override fun of(state: State): DoubleArray {
        val boundary = state.boundary
        val inPlane = isInPlane(boundary)
        val reach = farthest(boundary)
        require(farthest <= reach * (1 + ROUNDING)) {
            "pairs up to $farthest; the box, by half its shortest edge, has room for $reach"
        }
        val counts = DoubleArray(bins)
        val n = count(state, inPlane, counts)
        val size = if (inPlane) state.area else boundary.box.volume
        for (bin in 0 until bins) {
            val a = nearest + bin * width
            val b = nearest + (bin + 1) * width
            val shell = if (inPlane) PI * (b * b - a * a) else 4.0 / 3 * PI * (b * b * b - a * a * a)
            counts[bin] =
                if (n < 2) {
                    Double.NaN
                } else {
                    counts[bin] * 2 /
                        (n * (n - 1.0) / size * shell * room(boundary, inPlane, centre(bin)))
                }
        }
        return counts
    }

    /** Counts pairs by bin; the number of particles. */
    private fun count(state: State, inPlane: Boolean, counts: DoubleArray): Int {
        // Most that are looked at are farther away: they need no root.
        val far = farthest * farthest * (1 + ROUNDING)
        // In the plane, spheres one above the other are as near as if they lay at one height.
        forEachPair(state, farthest, inPlane) { _, _, square ->
            if (square < far) {
                val distance = sqrt(square)
                if (distance >= nearest) {
                    val bin = ((distance - nearest) / width).toInt()
                    if (bin < bins) counts[bin]++
                }
            }
        }
        return (0 until state.population.size).count(state::isParticle)
    }

    public companion object {
        /** Whether distances are counted in the x-y plane: where [boundary] has no images along z. */
        @JvmStatic
        public fun isInPlane(boundary: BoundaryConditions): Boolean = !boundary.hasImages(2)

        /**
         * The largest distance that [boundary] has room for: half the shortest edge along the axes in which distances
         * are counted.
         */
        @JvmStatic
        public fun farthest(boundary: BoundaryConditions): Double =
            (0..if (isInPlane(boundary)) 1 else 2).minOf { boundary.box.length(it) } / 2

        /**
         * Share of the displacements of length [distance], over all directions and places in the box, that end in the
         * box or an image.
         */
        private fun room(boundary: BoundaryConditions, inPlane: Boolean, distance: Double): Double {
            // A pair d apart along an open edge L has the share 1 − |d|/L of it; averages of |cos| and |cos sin| over
            // directions.
            val x = if (boundary.hasImages(0)) 0.0 else distance / boundary.box.length(0)
            val y = if (boundary.hasImages(1)) 0.0 else distance / boundary.box.length(1)
            return if (inPlane) 1 - 2 / PI * (x + y) + x * y / PI else 1 - (x + y) / 2 + 2 / (3 * PI) * x * y
        }

        private const val ROUNDING = 1e-9
    }
}
