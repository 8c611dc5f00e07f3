package daphnis.analysis.profile

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.PatchState
import kotlin.math.PI

/**
 * Profiles of a patch along one axis: radius (x), azimuth (y) or height (z), in equal bins. As a [Measure] it gives [COLUMNS] for each bin, entry
 * `bin · COLUMNS.size + column`.
 *
 * | column | what |
 * |---|---|
 * | count | particles whose centre is in the bin |
 * | surface_density | Σ m over the bin's area in the x-y plane; along z: Σ m over its volume |
 * | optical_depth | Σ π r² over that area (geometric); along z: over the area of the patch, so that bins add up to τ |
 * | filling_factor | volume of the spheres, cut at the bin's faces, over that of the bin; along x and y the height of the box is taken |
 * | mean_vx … | mean velocity against the flow that the boundary drives |
 * | c_xx … c_xy | ⟨c_a c_b⟩ around that mean, weighted by number |
 *
 * Means of an empty bin are NaN.
 *
 * @param axis 0, 1 or 2
 * @param from lower edge of the first bin
 * @param to upper edge of the last
 */
public class Profile(public val axis: Int, public val from: Double, public val to: Double, public val bins: Int) : Measure {
    init {
        require(axis in 0..2) { "axis is $axis; it must be 0, 1 or 2" }
        require(bins >= 1 && from < to) { "$bins bins from $from to $to; there must be one at least, and from below to" }
    }

    /** Middle of [bin]. */
    public fun centre(bin: Int): Double = from + (bin + 0.5) * (to - from) / bins

    override fun of(state: PatchState): DoubleArray {
        val p = state.population
        val a = if (axis == 0) {
            p.x
        } else if (axis == 1) {
            p.y
        } else {
            p.z
        }
        val width = (to - from) / bins
        val box = state.boundary.box
        // Area of a bin seen from above, and the area across which spheres are cut at its faces.
        val area = if (axis == 2) state.area else width * box.length(1 - axis)
        val section = if (axis == 2) state.area else box.length(1 - axis) * box.length(2)
        val result = DoubleArray(bins * WIDTH)
        for (k in 0 until p.size) {
            if (!state.isParticle(k)) continue
            addVolume(result, a[k], p.radius[k], width)
            val bin = Math.floor((a[k] - from) / width)
            if (bin < 0 || bin >= bins) continue
            val b = bin.toInt() * WIDTH
            result[b]++
            result[b + 1] += p.mass[k]
            result[b + 2] += PI * p.radius[k] * p.radius[k]
            val u = state.againstFlow(k, 0)
            val v = state.againstFlow(k, 1)
            val w = state.againstFlow(k, 2)
            result[b + 4] += u
            result[b + 5] += v
            result[b + 6] += w
            result[b + 7] += u * u
            result[b + 8] += v * v
            result[b + 9] += w * w
            result[b + 10] += u * v
        }
        for (bin in 0 until bins) finish(result, bin * WIDTH, if (axis == 2) area * width else area, area, section * width)
        return result
    }

    private fun finish(r: DoubleArray, b: Int, forMass: Double, area: Double, volume: Double) {
        val n = r[b]
        r[b + 1] /= forMass
        r[b + 2] /= area
        r[b + 3] /= volume
        for (c in 4 until WIDTH) r[b + c] = if (n == 0.0) Double.NaN else r[b + c] / n
        for (c in 0..2) r[b + 7 + c] = maxOf(0.0, r[b + 7 + c] - r[b + 4 + c] * r[b + 4 + c]).let { if (n == 0.0) Double.NaN else it }
        r[b + 10] -= r[b + 4] * r[b + 5]
    }

    /** Adds to each bin the part of a sphere that lies in it. */
    private fun addVolume(result: DoubleArray, centre: Double, radius: Double, width: Double) {
        val first = maxOf(0, Math.floor((centre - radius - from) / width).toInt())
        val last = minOf(bins - 1, Math.floor((centre + radius - from) / width).toInt())
        for (bin in first..last) {
            val low = from + bin * width
            result[bin * WIDTH + 3] += below(low + width - centre, radius) - below(low - centre, radius)
        }
    }

    /** Volume of the part of a sphere around 0 that lies below [h]. */
    private fun below(h: Double, radius: Double): Double {
        val t = (h / radius).coerceIn(-1.0, 1.0)
        return PI * radius * radius * radius * (2.0 / 3 + t - t * t * t / 3)
    }

    public companion object {
        public val COLUMNS: List<String> =
            listOf("count", "surface_density", "optical_depth", "filling_factor", "mean_vx", "mean_vy", "mean_vz", "c_xx", "c_yy", "c_zz", "c_xy")
        private val WIDTH = COLUMNS.size
    }
}
