package daphnis.analysis.movie

import daphnis.core.boundary.Box

/**
 * Axes in a picture.
 *
 * @property across the axis to the right; [up] the one that points up
 * @property depth the axis along which one looks
 * @property nearer 1 where what has a larger coordinate along [depth] is nearer, −1 where it is farther
 */
internal class Sight private constructor(val across: Int, val up: Int, val depth: Int, val nearer: Double) {
    companion object {
        /** Length over width from which a patch lies along its length, as in the pictures of a report. */
        private const val LONGEST = 4.0

        /** That of [view] of what is in [box]: y is to the right, or x of what is thin along y. */
        fun of(view: MovieView, box: Box): Sight {
            val isThin = box.length(0).isFinite() && box.length(0) > LONGEST * box.length(1)
            return when (view) {
                MovieView.TOP -> if (isThin) Sight(0, 1, 2, 1.0) else Sight(1, 0, 2, 1.0)
                MovieView.SIDE -> if (isThin) Sight(0, 2, 1, -1.0) else Sight(1, 2, 0, -1.0)
            }
        }
    }
}
