package daphnis.core.initial

import daphnis.core.boundary.Box
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor

/** What is known of a place for a sphere whose radius is known only within bounds. */
internal enum class Verdict { FREE, TAKEN, OPEN }

/**
 * The spheres placed so far, by rank, the largest first, in one linked-cell grid for each octave of radius. All of them
 * are at least as large as the sphere to be placed, so neighbouring cells suffice in every octave. Any number of
 * threads may read while none adds a sphere.
 *
 * @param order sphere by rank
 */
internal class OccupiedSpace(
    radii: DoubleArray,
    order: IntArray,
    private val box: Box,
    private val walled: BooleanArray,
    private val obstacles: List<Obstacle>,
) {
    /** A grid for spheres with radii in ([largest] / 2, [largest]]. */
    inner class Octave(val largest: Double, val cells: IntArray) {
        val heads = IntArray(cells[0] * cells[1] * cells[2]) { -1 }

        fun cell(axis: Int, position: Double): Int =
            floor((position - box.lower(axis)) / box.length(axis) * cells[axis]).toInt().coerceIn(
                0,
                cells[axis] - 1,
            )

        fun cell(x: Double, y: Double, z: Double): Int = (cell(2, z) * cells[1] + cell(1, y)) * cells[0] + cell(0, x)

        /**
         * First of the cells along [axis] in which something within [reach] of [position] can lie; the position itself,
         * when [slack] > 0, is known only within the slack across walls. May be −1, the last cell. With one or two
         * cells the neighbours on both sides are the same: visit each once.
         */
        fun first(axis: Int, position: Double, slack: Double, reach: Double): Int = if (slack > 0 && walled[axis]) {
            cell(axis, position - reach)
        } else {
            cell(axis, position) - (if (cells[axis] >= 3) 1 else 0)
        }

        fun last(axis: Int, position: Double, slack: Double, reach: Double): Int = if (slack > 0 && walled[axis]) {
            cell(axis, position + reach)
        } else {
            cell(axis, position) + (if (cells[axis] >= 2) 1 else 0)
        }

        fun wrap(axis: Int, cell: Int): Int = if (cell < 0) {
            cell + cells[axis]
        } else if (cell >= cells[axis]) {
            cell - cells[axis]
        } else {
            cell
        }
    }

    private val octaves = ArrayList<Octave>()
    private val next = IntArray(radii.size)
    private val lengths = DoubleArray(3) { box.length(it) }

    // x, y, z and radius by rank, in one cache line.
    private val spheres = DoubleArray(SPHERE * radii.size)

    init {
        for (rank in order.indices) spheres[SPHERE * rank + 3] = radii[order[rank]]
    }

    fun radius(rank: Int): Double = spheres[SPHERE * rank + 3]

    fun coordinate(rank: Int, axis: Int): Double = spheres[SPHERE * rank + axis]

    /** The octave of [radius], which is no larger than any before. */
    fun octaveFor(radius: Double): Octave {
        if (octaves.isEmpty() || octaves.last().largest > 2 * radius) octaves += octave(radius)
        return octaves.last()
    }

    private fun octave(largest: Double): Octave {
        // No more than a few cells per sphere, however empty the box.
        val most = maxOf(64.0, 4.0 * next.size)
        val width = maxOf(2 * largest, box.space.edge(box.volume / most))
        val axes = box.space.dimensions
        val cells = IntArray(3) { if (it < axes) (lengths[it] / width).coerceIn(1.0, 1e6).toInt() else 1 }
        while (cells[0].toDouble() * cells[1] * cells[2] > 8 * most) {
            for (k in 0..2) cells[k] = ceil(cells[k] / 2.0).toInt()
        }
        return Octave(largest, cells)
    }

    fun add(rank: Int, x: Double, y: Double, z: Double) {
        spheres[SPHERE * rank] = x
        spheres[SPHERE * rank + 1] = y
        spheres[SPHERE * rank + 2] = z
        val octave = octaveFor(radius(rank))
        val cell = octave.cell(x, y, z)
        next[rank] = octave.heads[cell]
        octave.heads[cell] = rank
    }

    fun isFree(x: Double, y: Double, z: Double, radius: Double): Boolean =
        verdict(x, y, z, radius, radius, 0.0) == Verdict.FREE

    /**
     * Whether a sphere can be at a place that is [slack] or less from ([x], [y], [z]), whichever of the radii [least]
     * to [most] it has. With no slack a sphere overlaps no less when it is larger, to the last bit: sums, squares and
     * comparisons are monotone in floating point.
     */
    fun verdict(x: Double, y: Double, z: Double, least: Double, most: Double, slack: Double): Verdict {
        var verdict = Verdict.FREE
        for (o in obstacles) {
            val found = verdict(distanceSquared(o.x, o.y, o.z, x, y, z), o.radius, least, most, slack)
            if (found == Verdict.TAKEN) return found
            if (found == Verdict.OPEN) verdict = found
        }
        for (k in octaves.indices) {
            val found = look(octaves[k], x, y, z, least, most, slack)
            if (found == Verdict.TAKEN) return found
            if (found == Verdict.OPEN) verdict = found
        }
        return verdict
    }

    private fun look(
        octave: Octave,
        x: Double,
        y: Double,
        z: Double,
        least: Double,
        most: Double,
        slack: Double,
    ): Verdict {
        val reach = octave.largest + most + slack
        val firstX = octave.first(0, x, slack, reach)
        val lastX = octave.last(0, x, slack, reach)
        val firstY = octave.first(1, y, slack, reach)
        val lastY = octave.last(1, y, slack, reach)
        var verdict = Verdict.FREE
        for (cz in octave.first(2, z, slack, reach)..octave.last(2, z, slack, reach)) {
            val layer = octave.wrap(2, cz) * octave.cells[1]
            for (cy in firstY..lastY) {
                val row = (layer + octave.wrap(1, cy)) * octave.cells[0]
                for (cx in firstX..lastX) {
                    var other = octave.heads[row + octave.wrap(0, cx)]
                    while (other >= 0) {
                        val at = SPHERE * other
                        val squared = distanceSquared(spheres[at], spheres[at + 1], spheres[at + 2], x, y, z)
                        val found = verdict(squared, spheres[at + 3], least, most, slack)
                        if (found == Verdict.TAKEN) return found
                        if (found == Verdict.OPEN) verdict = found
                        other = next[other]
                    }
                }
            }
        }
        return verdict
    }

    private fun verdict(squared: Double, other: Double, least: Double, most: Double, slack: Double): Verdict {
        val far = other + (most + slack)
        if (!(squared < far * far)) return Verdict.FREE
        val near = other + (least - slack)
        return if (near > 0 && squared < near * near) Verdict.TAKEN else Verdict.OPEN
    }

    fun distanceSquared(ox: Double, oy: Double, oz: Double, x: Double, y: Double, z: Double): Double {
        val dx = apart(ox - x, 0)
        val dy = apart(oy - y, 1)
        val dz = apart(oz - z, 2)
        return dx * dx + dy * dy + dz * dz
    }

    /** To the nearest image; below half a box that is the sphere itself, and the division can be saved. */
    private fun apart(d: Double, axis: Int): Double {
        val length = lengths[axis]
        return if (walled[axis] || abs(d) < length / 2) d else d - length * Math.rint(d / length)
    }

    private companion object {
        const val SPHERE = 4
    }
}
