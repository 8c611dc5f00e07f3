package daphnis.analysis.correlation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.SphereGroups
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
 * With [groups] it is that of each pair of groups, g_ab(r), for a ≤ b: entries from [first] (a, b) on. Pairs of a group
 * with itself are over those of its n(n − 1)/2, others over n_a n_b; NaN where there are no such pairs.
 *
 * @param farthest largest distance; at most half the shortest edge of the box along the axes in which distances are
 *   counted
 */
public class PairCorrelation @JvmOverloads constructor(
    public val farthest: Double,
    public val bins: Int,
    public val nearest: Double = 0.0,
    private val groups: SphereGroups = SphereGroups.ALL,
) : Measure {
    init {
        require(nearest >= 0 && farthest > nearest && farthest.isFinite() && bins >= 1) {
            "$bins bins from $nearest to $farthest; there must be one at least, of a width > 0, from a distance >= 0 on"
        }
    }

    private val width = (farthest - nearest) / bins

    /** Middle of [bin]. */
    public fun centre(bin: Int): Double = nearest + (bin + 0.5) * width

    /** Where the bins of pairs of the groups [a] and [b] begin among the numbers: both orders are one. */
    public fun first(a: Int, b: Int): Int {
        val low = minOf(a, b)
        require(low >= 0 && maxOf(a, b) < groups.count) { "groups $a and $b; there are ${groups.count}, from 0 on" }
        return (low * (2 * groups.count - low - 1) / 2 + maxOf(a, b)) * bins
    }

    /** @throws IllegalArgumentException when the box is too small for [farthest] */
    override fun of(state: State): DoubleArray {
        val boundary = state.boundary
        val inPlane = isInPlane(boundary)
        val reach = farthest(boundary)
        require(farthest <= reach * (1 + ROUNDING)) {
            "pairs up to $farthest; the box, by half its shortest edge, has room for $reach"
        }
        val group = IntArray(state.population.size) { if (state.isParticle(it)) groups.of(state, it) else -1 }
        val counts = DoubleArray(bins * groups.count * (groups.count + 1) / 2)
        count(state, inPlane, group, counts)
        val members = IntArray(groups.count) { g -> group.count { it == g } }
        val size = if (inPlane) state.area else boundary.box.volume
        for (bin in 0 until bins) {
            val a = nearest + bin * width
            val b = nearest + (bin + 1) * width
            val shell = if (inPlane) PI * (b * b - a * a) else 4.0 / 3 * PI * (b * b * b - a * a * a)
            for (a in members.indices) {
                for (b in a until members.size) {
                    val at = first(a, b) + bin
                    val pairs = members[a] * (if (a == b) members[a] - 1.0 else 2.0 * members[b])
                    val room = pairs / size * shell * room(boundary, inPlane, centre(bin))
                    counts[at] = if (pairs > 0) counts[at] * 2 / room else Double.NaN
                }
            }
        }
        return counts
    }

    /** Counts pairs by their groups and by bin. */
    private fun count(state: State, inPlane: Boolean, group: IntArray, counts: DoubleArray) {
        // Most that are looked at are farther away: they need no root.
        val far = farthest * farthest * (1 + ROUNDING)
        // In the plane, spheres one above the other are as near as if they lay at one height.
        forEachPair(state, farthest, inPlane) { i, j, square ->
            if (square < far && group[i] >= 0 && group[j] >= 0) {
                val distance = sqrt(square)
                if (distance >= nearest) {
                    val bin = ((distance - nearest) / width).toInt()
                    if (bin < bins) counts[first(group[i], group[j]) + bin]++
                }
            }
        }
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
