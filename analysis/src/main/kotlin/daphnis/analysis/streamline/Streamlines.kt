package daphnis.analysis.streamline

import daphnis.analysis.insitu.State
import daphnis.analysis.order.RadialKey
import daphnis.analysis.order.RadialOrder
import daphnis.core.orbit.OrbitalFrequencies
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.hypot
import kotlin.math.sqrt

/**
 * Streamlines as ring dynamicists define them (Lewis & Stewart 2000, AJ 120, 3295; Lewis's SwiftVis): the patch is cut
 * into slabs of azimuth; in each the particles, sorted by radial distance, are cut into groups of equal count.
 * Streamline k goes through the mean place of group k from slab to slab.
 *
 * Errors are one standard error, from the scatter of the particles of a group (over its number minus one), as if they
 * were independent; NaN for fewer than [FEWEST_FOR_ERROR], whose scatter says too little.
 *
 * Arrays are by group and slab: entry `slab · groups + group`, groups from the inside out, slabs from low y to high. A
 * group of an empty slab, and one that gets no particle, has count 0 and NaN elsewhere.
 *
 * @property slabs number of slabs; [slabWidth] is their width along y
 * @property groups number of groups in a slab
 * @property key what particles were sorted by
 */
public class Streamlines private constructor(
    public val slabs: Int,
    public val groups: Int,
    public val slabWidth: Double,
    public val key: RadialKey,
) {
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

    /**
     * Error of [meanX] for a given [guidingX], of groups sorted by guiding centre. NaN for groups sorted by x, because
     * the sort sets their places.
     */
    public val meanXError: DoubleArray = nan()

    /**
     * Optical depth Σ π r² / (Δs Δy). s is the sort key: x, or the guiding centre X. With X it is the depth that the
     * ring would have on circular orbits. Δs is between the middles of neighbouring groups, which are at the mean s. At
     * the ends of a periodic patch the neighbour is the image of the group at the other end; without an image the group
     * reaches as far outward from its middle as inward. With n independent particles per group the relative scatter of
     * Δs² is 5/(12 n), or 2/(3 n) at an end. Minus 1/(n · groups), because the length of a slab is fixed, this is the
     * relative bias of the mean of 1/Δs, which is corrected.
     */
    public val opticalDepth: DoubleArray = nan()
    public val opticalDepthError: DoubleArray = nan()

    /**
     * Residual velocity dispersion, around the group's mean velocity, the shear −(3/2)Ωx subtracted; every particle has
     * the same weight. The bias of the root of few squares is corrected.
     */
    public val dispersion: DoubleArray = nan()
    public val dispersionError: DoubleArray = nan()

    /**
     * Mean amplitude e of the epicycles, and i of the vertical motion, in units of length. NaN without Hill's frame,
     * like all properties below.
     */
    public val meanE: DoubleArray = nan()
    public val meanEError: DoubleArray = nan()
    public val meanI: DoubleArray = nan()
    public val meanIError: DoubleArray = nan()

    /**
     * Mean phase φ: direction of Σ e·exp(iφ), unwrapped from slab to slab; its error in radians, for errors well below
     * 1.
     */
    public val phase: DoubleArray = nan()
    public val phaseError: DoubleArray = nan()

    /**
     * Forced eccentricity |⟨e·exp(iφ)⟩|, in units of length: the common part of the particles of a group. Random
     * epicycles alone make it √(π/4) ⟨e²⟩^½/√n of n particles; [forcedEUnbiased] is √(|⟨e·exp(iφ)⟩|² − its expected
     * noise), 0 where the noise is larger.
     */
    public val forcedE: DoubleArray = nan()
    public val forcedEError: DoubleArray = nan()
    public val forcedEUnbiased: DoubleArray = nan()

    /**
     * q = |d(e·exp(iφ))/dX| between neighbouring streamlines: where it reaches 1 they cross (Borderies, Goldreich &
     * Tremaine 1982, Nature 299, 209). Noise raises it; below about two of its errors it has no meaning.
     */
    public val q: DoubleArray = nan()
    public val qError: DoubleArray = nan()

    /** Distance in x from this streamline to the next one out; negative where they have crossed. */
    public val spacing: DoubleArray = nan()

    private val forcedCos = nan()
    private val forcedSin = nan()

    /** Squared error of the mean of e·exp(iφ), of both directions together. */
    private val noise = nan()

    /** Σ π r², and the square of its error. */
    private val area = nan()
    private val areaScatter = nan()

    /** Entry of [group] in [slab]. */
    public fun at(slab: Int, group: Int): Int = slab * groups + group

    private fun nan() = DoubleArray(n) { Double.NaN }

    private fun measure(state: State, group: StreamlineGroup, entry: Int) {
        val n = group.size
        count[entry] = n
        if (n == 0) return
        val p = state.population
        meanX[entry] = group.mean { p.x[it] }
        meanY[entry] = group.mean { p.y[it] }
        minX[entry] = group.least { p.x[it] }
        maxX[entry] = -group.least { -p.x[it] }
        area[entry] = group.sum { PI * p.radius[it] * p.radius[it] }
        areaScatter[entry] = group.variance { PI * p.radius[it] * p.radius[it] } * n
        val mean = DoubleArray(3) { axis -> group.mean { state.againstFlow(it, axis) } }
        val squares = DoubleArray(3) { axis -> group.variance { state.againstFlow(it, axis) } }
        val square = squares.sum()
        dispersion[entry] = rootOfFew(squares, n)
        val spread = group.variance { k ->
            val u = state.againstFlow(k, 0) - mean[0]
            val v = state.againstFlow(k, 1) - mean[1]
            val w = state.againstFlow(k, 2) - mean[2]
            u * u + v * v + w * w
        }
        // Squares around a mean that is taken from n particles vary less than those around the true one.
        val part = n.toDouble() / (n - 1)
        if (square > 0) dispersionError[entry] = sqrt(spread / n * part) * part / (2 * sqrt(square)) orNone n
        val orbits = state.frequencies
        if (orbits == null) guidingX[entry] = meanX[entry] else epicycles(state, orbits, group, entry)
    }

    private fun epicycles(state: State, orbits: OrbitalFrequencies, group: StreamlineGroup, entry: Int) {
        val p = state.population
        val n = group.size
        val vertical = orbits.omega * Math.max(orbits.verticalFactor, 1e-300)
        fun cosine(k: Int) = orbits.inwards(p.x[k], p.vy[k])
        fun sine(k: Int) = p.vx[k] / orbits.kappa
        guidingX[entry] = group.mean { p.x[it] + cosine(it) }
        if (key == RadialKey.GUIDING_CENTRE) meanXError[entry] = sqrt(group.variance { cosine(it) } / n) orNone n
        meanE[entry] = group.mean { hypot(cosine(it), sine(it)) }
        meanEError[entry] = sqrt(group.variance { hypot(cosine(it), sine(it)) } / n) orNone n
        meanI[entry] = group.mean { hypot(p.z[it], p.vz[it] / vertical) }
        meanIError[entry] = sqrt(group.variance { hypot(p.z[it], p.vz[it] / vertical) } / n) orNone n
        val c = group.mean { cosine(it) }
        val s = group.mean { sine(it) }
        val forced = hypot(c, s)
        forcedCos[entry] = c
        forcedSin[entry] = s
        forcedE[entry] = forced
        phase[entry] = atan2(s, c)
        noise[entry] = (group.variance { cosine(it) } + group.variance { sine(it) }) / n
        forcedEUnbiased[entry] =
            sqrt(Math.max(0.0, forced * forced - noise[entry]).let { if (noise[entry].isNaN()) Double.NaN else it })
        if (forced == 0.0) return
        // Along the mean, and across it.
        forcedEError[entry] = sqrt(group.variance { (cosine(it) * c + sine(it) * s) / forced } / n) orNone n
        phaseError[entry] = sqrt(group.variance { (sine(it) * c - cosine(it) * s) / forced } / n) / forced orNone n
    }

    /**
     * Optical depths of [slab] from the middles of its groups, with images [period] apart; infinite means no images.
     */
    private fun depths(slab: Int, period: Double) {
        val filled = (0 until groups).map { at(slab, it) }.filter { count[it] > 0 }
        if (filled.isEmpty()) return
        val middle = if (key == RadialKey.GUIDING_CENTRE) guidingX else meanX
        for ((place, entry) in filled.withIndex()) {
            val inner = if (place > 0) middle[filled[place - 1]] else middle[filled.last()] - period
            val outer = if (place < filled.size - 1) middle[filled[place + 1]] else middle[filled.first()] + period
            val atEnd = inner.isInfinite() || outer.isInfinite()
            val width = if (filled.size == 1 && atEnd) {
                (maxX[entry] - minX[entry]) * (count[entry] + 1) / (count[entry] - 1)
            } else if (filled.size == 1) {
                period
            } else if (inner.isInfinite()) {
                outer - middle[entry]
            } else if (outer.isInfinite()) {
                middle[entry] - inner
            } else {
                (outer - inner) / 2
            }
            if (!(width > 0)) continue
            val scatter = if (atEnd) END_SCATTER else SCATTER
            val excess = Math.max(0.0, scatter - 1.0 / filled.size) / count[entry]
            opticalDepth[entry] = area[entry] / (width * slabWidth) * (1 - excess)
            opticalDepthError[entry] =
                opticalDepth[entry] *
                sqrt(scatter / count[entry] + areaScatter[entry] / (area[entry] * area[entry])) orNone count[entry]
        }
    }

    private fun compareNeighbours() {
        for (slab in 0 until slabs) {
            for (group in 0 until groups) {
                val k = at(slab, group)
                if (group + 1 < groups) spacing[k] = meanX[k + 1] - meanX[k]
                val inner = if (group > 0) k - 1 else k
                val outer = if (group + 1 < groups) k + 1 else k
                val distance = guidingX[outer] - guidingX[inner]
                if (outer == inner || distance == 0.0) continue
                q[k] =
                    hypot(forcedCos[outer] - forcedCos[inner], forcedSin[outer] - forcedSin[inner]) / Math.abs(distance)
                // Noise of one direction is half of that of both.
                qError[k] =
                    sqrt((noise[outer] + noise[inner]) / 2) / Math.abs(distance) orNone
                    minOf(count[outer], count[inner])
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

    /** This error of [particles] particles, or NaN of too few. */
    private infix fun Double.orNone(particles: Int) = if (particles < FEWEST_FOR_ERROR) Double.NaN else this

    public companion object {
        /** Particles of a group below which no error is given. */
        public const val FEWEST_FOR_ERROR: Int = 10

        /**
         * Variance of the width between the middles of a group's neighbours, times n, of its square: n independent
         * particles in each.
         */
        private const val SCATTER = 5.0 / 12

        /** The same at an end without an image, from the group's middle to that of its neighbour. */
        private const val END_SCATTER = 2.0 / 3

        /**
         * Cuts the particles of [state] into [slabs] of azimuth and [groups] in each. Linear in N beside the sort.
         *
         * @param key what to sort by; the guiding centre needs Hill's frame
         * @param order an order to be reused; it contains the ranks afterwards
         */
        @JvmStatic
        @JvmOverloads
        public fun of(
            state: State,
            slabs: Int,
            groups: Int,
            key: RadialKey = RadialKey.X,
            order: RadialOrder = RadialOrder(),
        ): Streamlines {
            require(slabs >= 1) { "$slabs slabs; there must be at least one" }
            require(groups >= 1) { "$groups groups; there must be at least one" }
            order.sort(state, key)
            val strip = strip(state)
            val low = strip[0]
            val width = (strip[1] - strip[0]) / slabs
            val p = state.population
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
            val period = if (state.boundary.hasImages(0)) state.boundary.box.length(0) else Double.POSITIVE_INFINITY
            val lines = Streamlines(slabs, groups, width, key)
            val group = StreamlineGroup(members)
            for (s in 0 until slabs) {
                val size = (start[s + 1] - start[s]).toLong()
                for (g in 0 until groups) {
                    group.span(start[s] + (size * g / groups).toInt(), start[s] + (size * (g + 1) / groups).toInt())
                    lines.measure(state, group, lines.at(s, g))
                }
                lines.depths(s, period)
            }
            lines.compareNeighbours()
            return lines
        }
    }
}
