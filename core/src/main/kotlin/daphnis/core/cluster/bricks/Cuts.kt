package daphnis.core.cluster.bricks

import daphnis.core.boundary.BoundaryConditions

/**
 * The planes that cut space into bricks: [planes] holds for each of x, y, z their positions in ascending order. One
 * part of space lies between two planes. Along a periodic axis n planes make n parts, of which the last goes on across
 * the face of the box to the first plane; fewer than two planes do not cut it. Along another axis n planes make n + 1
 * parts, of which the outermost have no end. Immutable.
 *
 * Slabs are cut along one axis, pencils along two, blocks along three.
 */
internal class Cuts(private val planes: List<DoubleArray>, private val boundary: BoundaryConditions) {
    private val periodic = BooleanArray(AXES) { boundary.hasImages(it) }

    /** Number of parts along [axis]. */
    fun parts(axis: Int): Int = if (periodic[axis]) maxOf(planes[axis].size, 1) else planes[axis].size + 1

    private val isCut = BooleanArray(AXES) { parts(it) > 1 }

    fun isCut(axis: Int): Boolean = isCut[axis]

    /** The same cuts in the box of [now], which has other bounds along axes that have images: they move in proportion. */
    fun within(now: BoundaryConditions): Cuts = Cuts(
        planes.mapIndexed { axis, at ->
            val from = boundary.box.lower(axis)
            val to = now.box.lower(axis)
            val by = if (periodic[axis]) now.box.length(axis) / boundary.box.length(axis) else 1.0
            val top = now.box.upper(axis)
            if (by == 1.0) at else DoubleArray(at.size) { (to + (at[it] - from) * by).coerceIn(to, top) }
        },
        now,
    )

    /** Whether they were made for the box of [now]. */
    fun areOf(now: BoundaryConditions): Boolean = (0 until AXES).all {
        !periodic[it] || now.box.lower(it) == boundary.box.lower(it) && now.box.upper(it) == boundary.box.upper(it)
    }

    /** Lower end of [part] along [axis]; −∞ where there is none. */
    fun lower(axis: Int, part: Int): Double = when {
        !isCut(axis) -> Double.NEGATIVE_INFINITY
        periodic[axis] -> planes[axis][part]
        part == 0 -> Double.NEGATIVE_INFINITY
        else -> planes[axis][part - 1]
    }

    /** The part along [axis] to which the position [x] in the box belongs. */
    fun partOf(axis: Int, x: Double): Int {
        if (!isCut(axis)) return 0
        val planes = planes[axis]
        var below = 0
        while (below < planes.size && x >= planes[below]) below++
        if (!periodic[axis]) return below
        return if (below == 0) planes.size - 1 else below - 1
    }

    companion object {
        const val AXES = 3
    }
}
