package daphnis.analysis.profile

import daphnis.analysis.insitu.PooledMeasure
import daphnis.analysis.insitu.State
import daphnis.core.space.Space
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.asin
import kotlin.math.sqrt

/**
 * Profiles of a patch along one axis: radius (x), azimuth (y) or height (z), in equal bins. As a [PooledMeasure] it
 * gives [COLUMNS] for each bin, entry `bin · COLUMNS.size + column`.
 *
 * | column | what |
 * |---|---|
 * | count | particles whose centre is in the bin, in one state |
 * | surface_density | Σ m over the bin's area in the x-y plane; along z: Σ m over its volume |
 * | optical_depth | Σ π r² over that area (geometric); along z: over the area of the patch, so that bins add up to τ |
 * | filling_factor | volume of the spheres cut at the bin's faces, over the bin's volume (along x, y: full height); of discs areas |
 * | mean_vx … | mean velocity relative to the flow that the boundary drives |
 * | c_xx … c_xy | ⟨c_a c_b⟩ around that mean, weighted by number: sums of products over the number minus one |
 *
 * Means and ⟨c_a c_b⟩ are over the particles of all states together, so the weight of a state is its number of
 * particles in the bin. Means of a bin without a particle in any state are NaN, and so are ⟨c_a c_b⟩ of fewer than two
 * particles. If a profile spans a whole period, the part of a sphere that sticks out at one end is counted at the
 * other. At ends that are not periodic it is cut off.
 *
 * @param axis 0, 1 or 2
 * @param from lower edge of the first bin
 * @param to upper edge of the last
 */
public class Profile(public val axis: Int, public val from: Double, public val to: Double, public val bins: Int) :
    PooledMeasure {
    init {
        require(axis in 0..2) { "axis is $axis; it must be 0, 1 or 2" }
        require(bins >= 1 && from < to) {
            "$bins bins from $from to $to; there must be one at least, and from below to"
        }
    }

    /** Middle of [bin]. */
    public fun centre(bin: Int): Double = from + (bin + 0.5) * (to - from) / bins

    /** By bin: [COLUMNS] up to the filling factor, then Σ of velocities and of their products. */
    override fun sums(state: State): DoubleArray {
        val p = state.population
        val a = if (axis == 0) {
            p.x
        } else if (axis == 1) {
            p.y
        } else {
            p.z
        }
        val width = (to - from) / bins
        val period = period(state)
        val space = state.boundary.space
        val result = DoubleArray(bins * WIDTH)
        for (k in 0 until p.size) {
            if (!state.isParticle(k)) continue
            val r = p.radius[k]
            addVolume(result, a[k], r, width, space)
            if (a[k] - r < from) addVolume(result, a[k] + period, r, width, space)
            if (a[k] + r > to) addVolume(result, a[k] - period, r, width, space)
            val bin = Math.floor((a[k] - from) / width)
            if (bin >= 0 && bin < bins) addParticle(result, bin.toInt() * WIDTH, state, k)
        }
        val box = state.boundary.box
        // Area of a bin seen from above, and the area across which spheres are cut at its faces.
        val area = if (axis == 2) state.area else width * box.length(1 - axis)
        val section = if (axis == 2) state.area else box.length(1 - axis) * box.length(2)
        // In a flat box, which is one unit thick, sections are lengths and discs are cut into parts of their area.
        for (b in result.indices step WIDTH) {
            result[b + MASS] /= if (axis == 2) area * width else area
            result[b + DEPTH] /= area
            result[b + VOLUME] /= section * width
        }
        return result
    }

    /** The period of the axis if the profile spans it; otherwise infinite, so that there are no images. */
    private fun period(state: State): Double {
        val box = state.boundary.box
        val length = box.length(axis)
        val whole = abs(from - box.lower(axis)) <= SAME * length && abs(to - box.lower(axis) - length) <= SAME * length
        return if (whole && state.boundary.repeats(axis)) length else Double.POSITIVE_INFINITY
    }

    private fun addParticle(r: DoubleArray, b: Int, state: State, k: Int) {
        val p = state.population
        val u = state.againstFlow(k, 0)
        val v = state.againstFlow(k, 1)
        val w = state.againstFlow(k, 2)
        r[b]++
        r[b + MASS] += p.mass[k]
        r[b + DEPTH] += PI * p.radius[k] * p.radius[k]
        r[b + MEAN] += u
        r[b + MEAN + 1] += v
        r[b + MEAN + 2] += w
        r[b + SQUARE] += u * u
        r[b + SQUARE + 1] += v * v
        r[b + SQUARE + 2] += w * w
        r[b + PRODUCT] += u * v
    }

    override fun finish(sums: DoubleArray, states: Int): DoubleArray {
        val r = sums.copyOf()
        for (b in r.indices step WIDTH) {
            val n = r[b]
            for (c in 0 until MEAN) r[b + c] /= states.toDouble()
            for (c in MEAN until SQUARE) r[b + c] = if (n > 0) r[b + c] / n else Double.NaN
            for (c in SQUARE until WIDTH) {
                val first = if (c == PRODUCT) 0 else c - SQUARE
                val second = if (c == PRODUCT) 1 else first
                r[b + c] =
                    if (n > 1) (r[b + c] - n * r[b + MEAN + first] * r[b + MEAN + second]) / (n - 1) else Double.NaN
            }
            for (c in SQUARE until PRODUCT) if (r[b + c] < 0) r[b + c] = 0.0
        }
        return r
    }

    /** Adds to each bin the part of a sphere that lies in it. */
    private fun addVolume(result: DoubleArray, centre: Double, radius: Double, width: Double, space: Space) {
        if (centre.isInfinite()) return
        val first = maxOf(0, Math.floor((centre - radius - from) / width).toInt())
        val last = minOf(bins - 1, Math.floor((centre + radius - from) / width).toInt())
        for (bin in first..last) {
            val low = from + bin * width
            result[bin * WIDTH + VOLUME] +=
                below(low + width - centre, radius, space) - below(low - centre, radius, space)
        }
    }

    /** Volume of the part of a sphere, area of that of a disc, around 0 that lies below [h]. */
    private fun below(h: Double, radius: Double, space: Space): Double {
        val t = (h / radius).coerceIn(-1.0, 1.0)
        if (space.isPlane) return radius * radius * (PI / 2 + t * sqrt(1 - t * t) + asin(t))
        return PI * radius * radius * radius * (2.0 / 3 + t - t * t * t / 3)
    }

    public companion object {
        @JvmField
        public val COLUMNS: List<String> =
            listOf("count", "surface_density", "optical_depth", "filling_factor") +
                listOf("mean_vx", "mean_vy", "mean_vz", "c_xx", "c_yy", "c_zz", "c_xy")
        private val WIDTH = COLUMNS.size
        private const val MASS = 1
        private const val DEPTH = 2
        private const val VOLUME = 3
        private const val MEAN = 4
        private const val SQUARE = 7
        private const val PRODUCT = 10

        /** Fraction of a length by which two ends may differ and still count as equal. */
        private const val SAME = 1e-9
    }
}
