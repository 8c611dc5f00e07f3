package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.parallel.Extremes
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns

/**
 * The part of space over which a [Grid] lays its cells: along a periodic axis the box, or the stretch of it in which
 * the spheres lie; along other axes the stretch in which they lie. Arrays are indexed by x, y, z.
 */
internal class GridExtent {
    private val extremes = Extremes()

    /** Lower end and length of the box along a periodic axis, of [spanFrom] and [span] along others. */
    val from = DoubleArray(3)
    val size = DoubleArray(3)

    /**
     * Lower end and length of the stretch in which the spheres lie. Along a periodic axis it may lie across a face, and
     * is the whole box unless there is room to spare.
     */
    val spanFrom = DoubleArray(3)
    val span = DoubleArray(3)

    /** Takes over the stretch in which spheres lie that are [measured] along axes without images. */
    fun take(measured: StepBounds, boundary: BoundaryConditions) {
        for (axis in 0..2) {
            val isPeriodic = boundary.hasImages(axis)
            from[axis] =
                if (isPeriodic) {
                    boundary.box.lower(axis)
                } else if (measured.isEmpty) {
                    0.0
                } else {
                    measured.lowest[axis]
                }
            size[axis] =
                if (isPeriodic) {
                    boundary.box.length(axis)
                } else if (measured.isEmpty) {
                    0.0
                } else {
                    measured.highest[axis] -
                        measured.lowest[axis]
                }
            spanFrom[axis] = from[axis]
            span[axis] = size[axis]
        }
    }

    /** Measures [spheres]; for [middle] see [Grid.build]. */
    fun measure(spheres: SphereColumns, boundary: BoundaryConditions, middle: DoubleArray, loop: RangeLoop) {
        for (axis in 0..2) {
            if (!boundary.hasImages(axis)) {
                measureOpen(axis, spheres, loop)
                continue
            }
            from[axis] = boundary.box.lower(axis)
            size[axis] = boundary.box.length(axis)
            spanFrom[axis] = from[axis]
            span[axis] = size[axis]
            if (!middle[axis].isNaN() && spheres.size > 0) measurePart(axis, spheres, middle[axis])
        }
    }

    private fun measureOpen(axis: Int, spheres: SphereColumns, loop: RangeLoop) {
        extremes.measure(spheres.position(axis), spheres.size, loop)
        from[axis] = if (spheres.size == 0) 0.0 else extremes.least
        size[axis] = if (spheres.size == 0) 0.0 else extremes.greatest - extremes.least
        spanFrom[axis] = from[axis]
        span[axis] = size[axis]
    }

    /** Takes of each sphere the image nearest to [middle]. */
    private fun measurePart(axis: Int, spheres: SphereColumns, middle: Double) {
        val position = spheres.position(axis)
        val length = size[axis]
        var least = Double.POSITIVE_INFINITY
        var most = Double.NEGATIVE_INFINITY
        for (k in 0 until spheres.size) {
            val inside = position[k].coerceIn(from[axis], from[axis] + length)
            val x = inside - length * Math.rint((inside - middle) / length)
            if (x < least) least = x
            if (x > most) most = x
        }
        if (most - least > length * WORTH_PART) return
        spanFrom[axis] = least
        span[axis] = most - least
    }

    /** @throws IllegalArgumentException see [Scales.requireLengths] */
    fun requireComputable(largestRadius: Double) {
        for (axis in 0..2) Scales.requireLengths(axis, from[axis], from[axis] + size[axis], largestRadius)
    }

    private companion object {
        /** With a larger part of the box, cells are laid over all of it. */
        const val WORTH_PART = 0.9
    }
}
