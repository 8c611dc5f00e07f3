package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.approachAlong
import daphnis.core.space.Images
import kotlin.math.abs

/**
 * How far away images along a periodic axis are searched, and how far spheres may therefore go within a step.
 */
internal object ImageRange {
    /** How many boxes away along an axis images are searched; the work of a step grows with the cube of this number. */
    const val MOST_BOXES: Int = 16

    /** Relative room for the rounding of cell numbers; round-off is some 1e-12 of it. */
    const val SLACK = 1e-9

    private const val ROUNDING_UNITS = 16

    /**
     * Absolute room for the rounding of positions between [low] and [high]: far from the origin it is larger than that
     * of the range.
     */
    fun rounding(low: Double, high: Double): Double = ROUNDING_UNITS * Math.ulp(maxOf(abs(low), abs(high)))

    /**
     * How many boxes away along [axis] images can be in a step of [duration]. Fewer than [MOST_BOXES] along the axis
     * across which images slide so fast that their boxes, counted along the slide as well, would not fit the code of an
     * image.
     */
    fun boxes(boundary: BoundaryConditions, axis: Int, duration: Double): Double {
        val shear = boundary.shear
        if (shear == null || axis != shear.normalAxis) return MOST_BOXES.toDouble()
        val slid = 1 + abs(shear.velocity) * duration / boundary.box.length(shear.slideAxis)
        return minOf(MOST_BOXES.toDouble(), (Images.FARTHEST - MOST_BOXES - 2) / slid - 2)
    }

    /**
     * The greatest distance that spheres with radii up to [largest] may go along [axis] from where they start; infinite
     * along an axis without images.
     */
    fun mostReach(boundary: BoundaryConditions, axis: Int, largest: Double, duration: Double): Double {
        if (!boundary.hasImages(axis)) return Double.POSITIVE_INFINITY
        val box = boundary.box
        val range = box.length(axis) * boxes(boundary, axis, duration) / 2
        val approached = abs(boundary.approachAlong(axis)) * duration
        val margin = range * (1 - 2 * approached) - box.length(axis) * approached
        return (margin - rounding(box.lower(axis), box.upper(axis))) * (1 - 2 * SLACK) - largest
    }

    /**
     * The [margin] along an axis of [length] where images come nearer by the part [approached] of their distance within a
     * step. One that is searched is at most 2 [margin] over [length] and one box away, and cells do not know that it moves.
     */
    fun marginWithApproach(margin: Double, length: Double, approached: Double): Double {
        val a = abs(approached)
        return (margin + a * length) / (1 - 2 * a)
    }

    fun refusal(axis: Int): String =
        "the fastest spheres meet images $MOST_BOXES boxes away along ${"xyz"[axis]} within a step; take a smaller dt"
}
