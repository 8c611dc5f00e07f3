package daphnis.analysis.brightness

import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.sqrt

/**
 * A ray through a [field], from box to box of images and within each from cell to cell (Amanatides & Woo 1987, Proc.
 * Eurographics '87, 3). Not thread-safe: it keeps what it met last.
 */
internal class FieldRay(private val field: SphereField) {
    private val origin = DoubleArray(AXES)
    private val direction = DoubleArray(AXES)
    private val cell = IntArray(AXES)
    private val step = IntArray(AXES)

    /** How far it is to the next face of the cell along each axis, and from face to face. */
    private val next = DoubleArray(AXES)
    private val between = DoubleArray(AXES)

    /** How far the ray has come before this box. */
    private var before = 0.0
    private var nearest = Double.POSITIVE_INFINITY

    /** The sphere that [meets] has found. */
    var sphere = -1
        private set

    /** Unit normal of that sphere where it was met, along x, y and z. */
    val normal = DoubleArray(AXES)

    /** Whether the ray from (x, y, z), [from] outside of all spheres, along the unit vector [toward] meets none. */
    fun isFree(from: DoubleArray, toward: DoubleArray): Boolean {
        begin(from, toward)
        return !walk(isAny = true)
    }

    /** Whether the same ray meets a sphere; if so, [sphere] and [normal] are where it does first. */
    fun meets(from: DoubleArray, toward: DoubleArray): Boolean {
        begin(from, toward)
        return walk(isAny = false)
    }

    private fun begin(from: DoubleArray, toward: DoubleArray) {
        val (across, along) = field.across to field.along
        origin[0] = from[across]
        origin[1] = from[along]
        origin[2] = from[2]
        direction[0] = toward[across]
        direction[1] = toward[along]
        direction[2] = toward[2]
        before = 0.0
        nearest = Double.POSITIVE_INFINITY
        sphere = -1
    }

    private fun walk(isAny: Boolean): Boolean {
        if (!enter()) return false
        for (boxes in 0 until MOST_BOXES) {
            settle()
            var face: Int
            while (true) {
                if (test(isAny) && isAny) return true
                face = if (next[0] <= next[1] && next[0] <= next[2]) {
                    0
                } else if (next[1] <= next[2]) {
                    1
                } else {
                    2
                }
                if (before + next[face] >= nearest) return true
                cell[face] += step[face]
                if (cell[face] < 0 || cell[face] >= field.count[face]) break
                next[face] += between[face]
            }
            if (!field.repeats[face]) return sphere >= 0
            cross(face)
        }
        return sphere >= 0
    }

    /** Goes on to where the ray enters the room that the spheres have; false if it does not. */
    private fun enter(): Boolean {
        var from = 0.0
        var to = Double.POSITIVE_INFINITY
        for (axis in 0 until AXES) {
            if (field.repeats[axis]) continue
            val below = field.low[axis] - origin[axis]
            val above = field.high[axis] - origin[axis]
            val along = direction[axis]
            if (along == 0.0) {
                if (below > 0 || above < 0) return false
                continue
            }
            from = maxOf(from, if (along > 0) below / along else above / along)
            to = minOf(to, if (along > 0) above / along else below / along)
        }
        if (from > to) return false
        advance(from)
        return true
    }

    private fun advance(distance: Double) {
        for (axis in 0 until AXES) origin[axis] += distance * direction[axis]
        before += distance
        for (axis in 0..1) wrap(axis)
    }

    /** Into the box along [axis], 0 before 1. */
    private fun wrap(axis: Int) {
        if (!field.repeats[axis]) return
        val edge = field.high[axis] - field.low[axis]
        val boxes = floor((origin[axis] - field.low[axis]) / edge)
        if (boxes == 0.0) return
        origin[axis] -= boxes * edge
        if (axis == 0) origin[1] -= boxes * field.offset
    }

    /** Leaves the box through the face across [axis], and enters it on the other side. */
    private fun cross(axis: Int) {
        val distance = next[axis]
        for (k in 0 until AXES) origin[k] += distance * direction[k]
        before += distance
        origin[axis] = if (step[axis] > 0) field.low[axis] else field.high[axis]
        if (axis == 0) {
            origin[1] -= step[0] * field.offset
            wrap(1)
        }
    }

    /** Finds the cell of the origin, and how far the faces of cells are. */
    private fun settle() {
        for (axis in 0 until AXES) {
            val along = direction[axis]
            val own = field.cell(axis, origin[axis])
            cell[axis] = own
            step[axis] = if (along > 0) 1 else -1
            if (along == 0.0) {
                next[axis] = Double.POSITIVE_INFINITY
                continue
            }
            val face = field.low[axis] + (if (along > 0) own + 1 else own) * field.width[axis]
            next[axis] = maxOf(0.0, (face - origin[axis]) / along)
            between[axis] = field.width[axis] / abs(along)
        }
    }

    /** Looks at the spheres of the cell. A sphere is met where a ray comes nearer to its centre from outside. */
    private fun test(isAny: Boolean): Boolean {
        val at = (cell[0] * field.count[1] + cell[1]) * field.count[2] + cell[2]
        val (a, b, z) = origin
        val (da, db, dz) = direction
        for (entry in field.start[at] until field.start[at + 1]) {
            val k = field.entries[entry]
            val fromA = a - field.centreA[k]
            val fromB = b - field.centreB[k]
            val fromZ = z - field.z(k)
            val toward = fromA * da + fromB * db + fromZ * dz
            if (toward >= 0) continue
            val r = field.radius(k)
            val beside = toward * toward - (fromA * fromA + fromB * fromB + fromZ * fromZ) + r * r
            if (beside < 0) continue
            if (isAny) return true
            // Less than 0 where it begins within a sphere that overlaps its own: then it is met at once.
            val distance = maxOf(0.0, -toward - sqrt(beside))
            if (before + distance >= nearest) continue
            nearest = before + distance
            sphere = field.owner[k]
            normal[field.across] = (fromA + distance * da) / r
            normal[field.along] = (fromB + distance * db) / r
            normal[2] = (fromZ + distance * dz) / r
        }
        return false
    }

    private companion object {
        const val AXES = 3

        /**
         * Boxes after which a ray is taken to have left. Only those that are nearly parallel to the plane come so far,
         * as they can where gaps go on through all images.
         */
        const val MOST_BOXES = 10_000
    }
}
