package daphnis.analysis.occultation

import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.hypot
import kotlin.math.ln1p
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * Light through opaque spheres whose places in the plane are random: each alone, evenly spread over a periodic patch.
 * What comes through is exact, for spheres that may overlap:
 *
 * - a point is free with the probability ⟨T⟩ = Π (1 − a/𝒜), the product over the spheres of the shadows a = π r²/sin B
 *   and the area 𝒜 of the patch; exp(−τ/sin B) for very many;
 * - two points h apart are both free with the probability P(h) = Π (1 − (2a − γ(h))/𝒜), where γ is the area that two
 *   such shadows h apart have in common (the set covariance of a Boolean model; Matheron 1975, Random Sets);
 * - the mean over a footprint F has the variance ∫ C(h) (P(h) − ⟨T⟩²) dh / F², with C the set covariance of F.
 *
 * For a footprint much larger than a shadow that is ⟨T⟩² ∫ (exp(n γ) − 1) dh / F, n shadows per area, and for small
 * depths ⟨T⟩² (τ/sin B) a/F: the excess variance of Showalter & Nicholson 1990, Icarus 87, 285.
 *
 * @param radii of the spheres, one or more; of more than 64 sizes groups of equal number are taken at their rms radius
 * @param area of the patch
 */
public class RandomDiscs(radii: DoubleArray, private val area: Double, private val line: LineOfSight) {
    private val sine = sin(line.elevation)
    private val sizes: DoubleArray
    private val counts: DoubleArray

    init {
        require(radii.isNotEmpty()) { "no radii" }
        require(area > 0) { "area is $area; it must be > 0" }
        val sorted = radii.sortedArray()
        val groups = if (sorted.first() == sorted.last()) 1 else minOf(GROUPS, sorted.size)
        val ends = IntArray(groups + 1) { (it.toLong() * sorted.size / groups).toInt() }
        counts = DoubleArray(groups) { (ends[it + 1] - ends[it]).toDouble() }
        sizes = DoubleArray(groups) { g ->
            var squares = 0.0
            for (k in ends[g] until ends[g + 1]) squares += sorted[k] * sorted[k]
            if (groups == 1) sorted[0] else sqrt(squares / counts[g])
        }
    }

    /** Share of the light that comes through on average; NaN where the shadow of one is as large as half the patch. */
    public val transmission: Double = free { PI * sizes[it] * sizes[it] / sine }

    /**
     * Variance of the mean over a [footprint] whose path has the direction [path] in the plane, from x toward y in
     * radians. NaN where the shadow of one is as large as half the patch. Numerically to some 10⁻³ of itself.
     */
    public fun variance(footprint: Footprint, path: Double): Double {
        val apart = free { 2 * PI * sizes[it] * sizes[it] / sine }
        val toRaysU = cos(line.azimuth - path)
        val toRaysV = sin(line.azimuth - path)
        // As far as shadows, and the footprint, reach along the path and across it; h and −h are alike.
        val reach = 2 * sizes.max()
        val farU = minOf(footprint.length, reach * hypot(toRaysU / sine, toRaysV))
        val farV = minOf(footprint.width, reach * hypot(toRaysV / sine, toRaysU))
        val (stepU, stepV) = farU / CELLS to farV / CELLS
        var sum = 0.0
        for (i in 0 until CELLS) {
            val u = (i + 0.5) * stepU
            for (j in -CELLS until CELLS) {
                val v = (j + 0.5) * stepV
                // Where a shadow is a disc: along the rays distances are sin B of those in the plane.
                val h = hypot((u * toRaysU + v * toRaysV) * sine, v * toRaysU - u * toRaysV)
                if (h >= reach) continue
                val near = free { (2 * PI * sizes[it] * sizes[it] - Footprint.ofDiscs(sizes[it], h)) / sine }
                sum += (near - apart) * footprint.overlap(u, v)
            }
        }
        return 2 * sum * stepU * stepV / (footprint.area * footprint.area) + apart - transmission * transmission
    }

    /** Π (1 − s/𝒜) over all spheres, where s of the size k is [shadow] of k. */
    private inline fun free(shadow: (Int) -> Double): Double {
        var log = 0.0
        for (k in sizes.indices) {
            val part = shadow(k) / area
            if (part >= 1) return Double.NaN
            log += counts[k] * ln1p(-part)
        }
        return exp(log)
    }

    private companion object {
        const val GROUPS = 64

        /** Of the integral, along each half of an axis. */
        const val CELLS = 64
    }
}
