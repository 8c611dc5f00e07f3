package daphnis.analysis.insitu

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces

/**
 * Where the images of a patch stand, seen along z. Boxes of images lie in rows; a row goes on along the axis [along],
 * the rows follow one another along the axis [across], and the row at +m is displaced by m · [offset] along itself.
 * Without shear in the plane rows are columns of constant x and stand still.
 *
 * ```
 *   across ▲      ┌─────┐┌─────┐   row +1, displaced by the offset
 *          │   ┌──┴──┬──┴┴─┬───┘
 *          │   │     │     │       row 0
 *          └───┴─────┴─────┴──▶ along
 * ```
 */
internal class PlaneImages(boundary: BoundaryConditions, time: Double) {
    private val lengths = doubleArrayOf(boundary.box.length(0), boundary.box.length(1))
    private val periodic = BooleanArray(2) { boundary.contactFaces(it) == ContactFaces.PERIODIC }
    private val shear = boundary.shear?.takeIf { it.normalAxis < 2 && it.slideAxis < 2 }

    /** 0 (x) or 1 (y). */
    val across: Int = shear?.normalAxis ?: 0
    val along: Int = 1 - across

    /** Length, in [0, edge along [along]). */
    val offset: Double = shear?.offset(time) ?: 0.0

    /** Whether there are images along [axis], 0 or 1. */
    fun repeats(axis: Int): Boolean = periodic[axis]

    /** Displacement along [axis], 0 or 1, of the image [ix] boxes away along x and [iy] along y. */
    fun shift(ix: Int, iy: Int, axis: Int): Double {
        val own = (if (axis == 0) ix else iy) * lengths[axis]
        return if (axis == along) own + (if (across == 0) ix else iy) * offset else own
    }
}
