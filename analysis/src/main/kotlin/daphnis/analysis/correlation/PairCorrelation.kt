package daphnis.analysis.correlation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.PatchState
import daphnis.core.boundary.ContactFaces
import daphnis.core.search.CellRuns
import daphnis.core.search.Grid
import daphnis.core.search.SearchStructure
import kotlin.math.PI
import kotlin.math.sqrt

/**
 * Pair correlation: pairs at a distance over those that particles without correlation would have, by bin of distance from 0 to [farthest]. In a box periodic
 * along all axes it is the radial distribution function g(r) in space; where the patch is open vertically the distance is counted in the x-y plane.
 *
 * @param farthest largest distance; at most half the shortest periodic edge
 */
public class PairCorrelation(public val farthest: Double, public val bins: Int) : Measure {
    init {
        require(farthest > 0 && bins >= 1) { "$bins bins up to $farthest; both must be positive" }
    }

    /** Middle of [bin]. */
    public fun centre(bin: Int): Double = (bin + 0.5) * farthest / bins

    override fun of(state: PatchState): DoubleArray {
        val p = state.population
        val boundary = state.boundary
        val inPlane = boundary.contactFaces(2) != ContactFaces.PERIODIC
        val grid = Grid()
        grid.build(p, boundary, state.time, 0.0, DoubleArray(3), structure = SearchStructure.GRID)
        val near = CellRuns(grid)
        val counts = DoubleArray(bins)
        // In the plane everybody above and below is near.
        var height = 0.0
        if (inPlane && p.size > 0) height = p.z.max() - p.z.min()
        var n = 0
        for (slot in 0 until p.size) {
            val k = grid.order[slot]
            if (!state.isParticle(k)) continue
            n++
            // A sphere of that size touches whoever is near enough.
            val runs = near.ahead(slot, p.x[k], p.y[k], p.z[k], 0.0, 0.0, 0.0, sqrt(farthest * farthest + height * height))
            for (r in 0 until runs) {
                val image = near.image[r]
                for (other in near.from[r] until near.to[r]) {
                    val j = grid.order[other]
                    if (!state.isParticle(j)) continue
                    val dx = p.x[j] - p.x[k] + grid.images.shift(image, 0)
                    val dy = p.y[j] - p.y[k] + grid.images.shift(image, 1)
                    val dz = if (inPlane) 0.0 else p.z[j] - p.z[k] + grid.images.shift(image, 2)
                    val bin = (sqrt(dx * dx + dy * dy + dz * dz) / farthest * bins).toInt()
                    if (bin < bins) counts[bin]++
                }
            }
        }
        val size = if (inPlane) state.area else boundary.box.volume
        for (bin in 0 until bins) {
            val a = bin * farthest / bins
            val b = (bin + 1) * farthest / bins
            val shell = if (inPlane) PI * (b * b - a * a) else 4.0 / 3 * PI * (b * b * b - a * a * a)
            counts[bin] = if (n < 2) Double.NaN else counts[bin] * 2 / (n * (n - 1.0) / size * shell)
        }
        return counts
    }
}
