package daphnis.analysis.insitu

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.prepare
import daphnis.core.space.Images

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
public class PlaneImages(private val boundary: BoundaryConditions, time: Double) {
    private val images = Images().apply { prepare(boundary, time) }
    private val slides = images.normalAxis in 0..1 && images.slideAxis in 0..1

    /** 0 (x) or 1 (y). */
    public val across: Int = if (slides) images.normalAxis else 0

    /** The other of the two. */
    public val along: Int = 1 - across

    /** Length, in [0, edge along [along]). */
    public val offset: Double = if (slides) images.shearOffset else 0.0

    /** Whether there are images along [axis], 0 or 1. */
    public fun repeats(axis: Int): Boolean = boundary.hasImages(axis)

    /** Displacement along [axis], 0 or 1, of the image [ix] boxes away along x and [iy] along y. */
    public fun shift(ix: Int, iy: Int, axis: Int): Double = images.shift(Images.code(ix, iy, 0), axis)
}
