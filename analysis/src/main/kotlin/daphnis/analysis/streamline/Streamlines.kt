package daphnis.analysis.streamline

import daphnis.analysis.insitu.PatchState
import daphnis.analysis.order.RadialKey
import daphnis.analysis.order.RadialOrder
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.hypot
import kotlin.math.sqrt

/**
 * Streamlines as ring dynamicists read them (Lewis & Stewart 2000, AJ 120, 3295; Lewis's SwiftVis): the patch is cut into slabs of azimuth; in each the particles,
 * sorted by radial distance, are cut into groups of equal count. Streamline k goes through the mean place of group k from slab to slab.
 *
 * Arrays are by group and slab: entry `slab · groups + group`, groups from the inside out, slabs from low y to high. A group of an empty slab, and one that gets no
 * particle, has count 0 and NaN elsewhere.
 *
 * @property slabs number of slabs; [slabWidth] is their width along y
 * @property groups number of groups in a slab
 * @property key what particles were sorted by
 */
public class Streamlines private constructor(public val slabs: Int, public val groups: Int, public val slabWidth: Double, public val key: RadialKey) {
    private val n = slabs * groups

    /** Particles. */
    public val count: IntArray = IntArray(n)

    /** Mean x, mean y, least x, greatest x. */
    public val meanX: DoubleArray = nan()
    public val meanY: DoubleArray = nan()
    public val minX: DoubleArray = nan()
    public val maxX: DoubleArray = nan()

    /** Mean X of the guiding centres; x without Hill's frame. */
    public val guidingX: DoubleArray = nan()

    /** Optical depth Σ π r² / (Δx Δy), Δx from least to greatest x. */
    public val opticalDepth: DoubleArray = nan()

    /** Mean amplitude e of the epicycles, and i of the vertical motion, in units of length. NaN without Hill's frame, as all that follows. */
    public val meanE: DoubleArray = nan()
    public val meanI: DoubleArray = nan()

    /** Mean phase φ: direction of Σ e·exp(iφ), unwrapped from slab to slab. */
    public val phase: DoubleArray = nan()

    /** Forced eccentricity |⟨e·exp(iφ)⟩|, in units of length: what the particles of a group have in common. */
    public val forcedE: DoubleArray = nan()

    /** Residual velocity dispersion, around the group's mean velocity with the shear −(3/2)Ωx taken out. */
    public val dispersion: DoubleArray = nan()

    /** q = |d(e·exp(iφ))/dX| between neighbouring streamlines: where it reaches 1 they cross (Borderies, Goldreich & Tremaine 1982, Nature 299, 209). */
    public val q: DoubleArray = nan()

    /** Distance in x from this streamline to the next one out; negative where they have crossed. */
    public val spacing: DoubleArray = nan()

    private val forcedCos = nan()
    private val forcedSin = nan()

    /** Entry of [group] in [slab]. */
    public fun at(slab: Int, group: Int): Int = slab * groups + group

    private fun nan() = DoubleArray(n) { Double.NaN }

    private fun measure(state: PatchState, members: IntArray, first: Int, end: Int, entry: Int) {
        val size = end - first
        count[entry] = size
        if (size == 0) return
        val p = state.population
        val omega = state.omega
        var x = 0.0
        var y = 0.0
        var least = Double.POSITIVE_INFINITY
        var most = Double.NEGATIVE_INFINITY
        var area = 0.0
        var gx = 0.0
        var e = 0.0
        var i = 0.0
        var c = 0.0
        var s = 0.0
        val mean = DoubleArray(3)
        val square = DoubleArray(3)
        val vertical = if (omega == null) 1.0 else omega * maxOf(state.verticalFactor, 1e-300)
        for (m in first until end) {
            val k = members[m]
            x += p.x[k]
            y += p.y[k]
            least = Math.min(least, p.x[k])
            most = Math.max(most, p.x[k])
            area += PI * p.radius[k] * p.radius[k]
            for (axis in 0..2) {
                val v = state.againstFlow(k, axis)
                mean[axis] += v
                square[axis] += v * v
            }
            if (omega == null) {
                gx += p.x[k]
                continue
            }
            val guiding = 4 * p.x[k] + 2 * p.vy[k] / omega
            val cosine = guiding - p.x[k]
            val sine = p.vx[k] / omega
            gx += guiding
            c += cosine
            s += sine
            e += hypot(cosine, sine)
            i += hypot(p.z[k], p.vz[k] / vertical)
        }
        meanX[entry] = x / size
        meanY[entry] = y / size
        minX[entry] = least
        maxX[entry] = most
        guidingX[entry] = gx / size
        if (most > least) opticalDepth[entry] = area / ((most - least) * slabWidth)
        var variance = 0.0
        for (axis in 0..2) variance += Math.max(0.0, square[axis] / size - (mean[axis] / size) * (mean[axis] / size))
        dispersion[entry] = sqrt(variance)
        if (omega == null) return
        meanE[entry] = e / size
        meanI[entry] = i / size
        forcedCos[entry] = c / size
        forcedSin[entry] = s / size
        forcedE[entry] = hypot(c, s) / size
        phase[entry] = atan2(s, c)
    }

    private fun compareNeighbours() {
        for (slab in 0 until slabs) {
            for (group in 0 until groups) {
                val k = at(slab, group)
                if (group + 1 < groups) spacing[k] = meanX[k + 1] - meanX[k]
                val inner = if (group > 0) k - 1 else k
                val outer = if (group + 1 < groups) k + 1 else k
                val distance = guidingX[outer] - guidingX[inner]
                if (outer > inner && distance != 0.0) q[k] = hypot(forcedCos[outer] - forcedCos[inner], forcedSin[outer] - forcedSin[inner]) / Math.abs(distance)
            }
        }
        for (group in 0 until groups) {
            var last = Double.NaN
            for (slab in 0 until slabs) {
                val k = at(slab, group)
                if (phase[k].isNaN()) continue
                if (!last.isNaN()) phase[k] += 2 * PI * Math.rint((last - phase[k]) / (2 * PI))
                last = phase[k]
            }
        }
    }

    public companion object {
        /**
         * Cuts the particles of [state] into [slabs] of azimuth and [groups] in each. Linear in N beside the sort.
         *
         * @param key what to sort by; the guiding centre needs Hill's frame
         * @param order an order to be reused, whose ranks stay there for what follows
         */
        public fun of(state: PatchState, slabs: Int, groups: Int, key: RadialKey = RadialKey.X, order: RadialOrder = RadialOrder()): Streamlines {
            require(slabs >= 1) { "$slabs slabs; there must be at least one" }
            require(groups >= 1) { "$groups groups; there must be at least one" }
            order.sort(state, key)
            val p = state.population
            val low: Double
            val width: Double
            if (state.boundary.box.length(1).isFinite()) {
                low = state.boundary.box.lower(1)
                width = state.boundary.box.length(1) / slabs
            } else {
                var least = Double.POSITIVE_INFINITY
                var most = Double.NEGATIVE_INFINITY
                for (k in 0 until p.size) {
                    least = minOf(least, p.y[k])
                    most = maxOf(most, p.y[k])
                }
                low = if (p.size == 0) 0.0 else least
                width = if (p.size == 0 || most == least) 1.0 else (most - least) / slabs
            }
            fun slab(k: Int) = ((p.y[k] - low) / width).toInt().coerceIn(0, slabs - 1)
            // Members of a slab in radial order: a counting sort of the ranks.
            val start = IntArray(slabs + 2)
            for (k in 0 until p.size) if (state.isParticle(k)) start[slab(k) + 2]++
            for (s in 2..slabs) start[s] += start[s - 1]
            val members = IntArray(p.size)
            for (rank in 0 until order.size) {
                val k = order.order[rank]
                if (state.isParticle(k)) members[start[slab(k) + 1]++] = k
            }
            val lines = Streamlines(slabs, groups, width, key)
            for (s in 0 until slabs) {
                val size = (start[s + 1] - start[s]).toLong()
                for (g in 0 until groups) {
                    lines.measure(state, members, start[s] + (size * g / groups).toInt(), start[s] + (size * (g + 1) / groups).toInt(), lines.at(s, g))
                }
            }
            lines.compareNeighbours()
            return lines
        }
    }
}
