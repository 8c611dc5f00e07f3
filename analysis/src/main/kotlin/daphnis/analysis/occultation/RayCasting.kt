package daphnis.analysis.occultation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.PatchState
import daphnis.analysis.insitu.PooledMeasure
import daphnis.core.boundary.ContactFaces
import kotlin.math.PI
import kotlin.math.ceil
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.ln
import kotlin.math.sin

/**
 * Light through a patch: parallel rays at an elevation above the ring plane, on a regular grid of points of the plane, each blocked by the spheres it meets, images
 * included. What is blocked along a ray is found by the shadows: a sphere at height z shadows the ellipse around (x, y) − z/tan B · (cos A, sin A), with semi-axes r and
 * r / sin B, of the plane.
 *
 * @param elevation B, angle between the rays and the ring plane in radians, in (0, π/2]
 * @param azimuth A, direction of the rays' projection, from x toward y, in radians
 * @param rays rays along the longer edge of the patch, at most; rays along x and y are as far apart
 */
public class RayCasting(public val elevation: Double, public val azimuth: Double = 0.0, private val rays: Int = 1024) {
    init {
        require(elevation > 0 && elevation <= PI / 2) { "elevation is $elevation; it must be in (0, π/2]" }
        require(rays >= 1) { "$rays rays; there must be one at least" }
    }

    /**
     * Which rays come through, by cell of the plane.
     *
     * @property nx rays along x; [ny] along y; [blocked] at `i · ny + j`
     */
    public class Shadow internal constructor(public val nx: Int, public val ny: Int) {
        public val blocked: BooleanArray = BooleanArray(nx * ny)

        /** Part of the rays that come through, by place along x: a synthetic occultation scan. */
        public fun scan(): DoubleArray = DoubleArray(nx) { i -> (0 until ny).count { !blocked[i * ny + it] } / ny.toDouble() }

        /** Part of all rays that come through. */
        public val transmission: Double get() = blocked.count { !it } / blocked.size.toDouble()
    }

    /** Casts the rays through [state]. */
    public fun cast(state: PatchState): Shadow {
        val box = state.boundary.box
        val longest = maxOf(box.length(0), box.length(1))
        val shadow = Shadow(
            maxOf(1, Math.rint(rays * box.length(0) / longest).toInt()),
            maxOf(1, Math.rint(rays * box.length(1) / longest).toInt()),
        )
        val p = state.population
        for (k in 0 until p.size) drop(state, shadow, p.x[k], p.y[k], p.z[k], p.radius[k])
        return shadow
    }

    private fun drop(state: PatchState, shadow: Shadow, x: Double, y: Double, z: Double, r: Double) {
        val box = state.boundary.box
        val c = cos(azimuth)
        val s = sin(azimuth)
        val slope = if (elevation == PI / 2) 0.0 else z / Math.tan(elevation)
        val cx = x - slope * c
        val cy = y - slope * s
        val long = r / sin(elevation)
        val reach = maxOf(long, r)
        val dx = box.length(0) / shadow.nx
        val dy = box.length(1) / shadow.ny
        val shear = state.boundary.shear
        val offset = if (shear != null && shear.normalAxis == 0) shear.offset(state.time) else 0.0
        val wrapsX = state.boundary.contactFaces(0) == ContactFaces.PERIODIC
        val wrapsY = state.boundary.contactFaces(1) == ContactFaces.PERIODIC
        // Rays go through the middles of cells.
        for (i in ceil((cx - reach - box.lowerX) / dx - 0.5).toInt()..floor((cx + reach - box.lowerX) / dx - 0.5).toInt()) {
            val boxes = Math.floorDiv(i, shadow.nx)
            if (boxes != 0 && !wrapsX) continue
            val column = (i - boxes * shadow.nx) * shadow.ny
            // What falls beyond a radial face falls on the image there, which stands displaced by the slide.
            val shift = boxes * offset
            val px = box.lowerX + (i + 0.5) * dx - cx
            for (j in ceil((cy - shift - reach - box.lowerY) / dy - 0.5).toInt()..floor((cy - shift + reach - box.lowerY) / dy - 0.5).toInt()) {
                if (!wrapsY && (j < 0 || j >= shadow.ny)) continue
                val py = box.lowerY + (j + 0.5) * dy - (cy - shift)
                val along = (px * c + py * s) / long
                val across = (py * c - px * s) / r
                if (along * along + across * across <= 1) shadow.blocked[column + Math.floorMod(j, shadow.ny)] = true
            }
        }
    }

    /**
     * Transmission and normal optical depth −sin B · ln T as a [PooledMeasure]: the depth is that of the mean transmission of all states, for the mean of depths
     * would be too large in small patches. It is +∞ when nothing comes through.
     */
    public fun depth(): Measure = object : PooledMeasure {
        override fun sums(state: PatchState): DoubleArray = doubleArrayOf(cast(state).transmission)

        override fun finish(sums: DoubleArray, states: Int): DoubleArray {
            val t = sums[0] / states
            return doubleArrayOf(t, -sin(elevation) * ln(t))
        }
    }
}
