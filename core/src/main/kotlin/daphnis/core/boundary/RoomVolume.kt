package daphnis.core.boundary

import kotlin.math.PI
import kotlin.math.sqrt

/**
 * The volume, or in the plane the area, of what [surfaces] leave of a [box]: exact for a single cylinder or sphere that
 * lies in the box, and elsewhere to some 1e-4 of the box, by the lengths of parallel lines in the room.
 */
internal class RoomVolume(private val box: Box, private val surfaces: List<WallSurface>) {
    private val isPlane = box.space.isPlane

    /** Along which lines are followed. */
    private val along = if (isPlane) 1 else 2
    private val point = DoubleArray(AXES)

    fun value(): Double = exact() ?: byLines()

    private fun exact(): Double? {
        val only = surfaces.singleOrNull() ?: return null
        val axes = 0 until box.space.dimensions
        val across = axes.filter { !only.isSameAlong(it) }
        if (!across.all { only.encloses(it, box.lower(it), box.upper(it)) }) return null
        val r = only.radius
        if (only is WallSurface.Sphere) return 4.0 / 3.0 * PI * r * r * r
        return axes.filter { only.isSameAlong(it) }.fold(PI * r * r) { volume, axis -> volume * box.length(axis) }
    }

    private fun byLines(): Double {
        val count = if (isPlane) LINES * LINES else LINES
        val rows = if (isPlane) 1 else LINES
        var sum = 0.0
        for (row in 0 until rows) {
            if (!isPlane) point[1] = middle(1, row, rows)
            for (k in 0 until count) {
                point[0] = middle(0, k, count)
                sum += length()
            }
        }
        val area = if (isPlane) box.length(0) / count else box.length(0) / count * (box.length(1) / rows)
        return sum * area
    }

    private fun middle(axis: Int, k: Int, count: Int) = box.lower(axis) + box.length(axis) * (k + 0.5) / count

    /** Of the part of the line through [point] that is in the room. */
    private fun length(): Double {
        var from = box.lower(along)
        var to = box.upper(along)
        point[along] = 0.0
        for (surface in surfaces) {
            surface.cross(point, along) { first, last, isRoom ->
                if (isRoom) {
                    from = maxOf(from, first)
                    to = minOf(to, last)
                }
            }
        }
        if (to <= from) return 0.0
        val holes = ArrayList<Pair<Double, Double>>(0)
        for (surface in surfaces) {
            surface.cross(point, along) { first, last, isRoom ->
                if (!isRoom && last > from && first < to) holes += Pair(maxOf(first, from), minOf(last, to))
            }
        }
        var free = to - from
        var done = from
        for ((first, last) in holes.sortedBy { it.first }) {
            free -= maxOf(0.0, last - maxOf(first, done))
            done = maxOf(done, last)
        }
        return free
    }

    /**
     * Tells [use] where the line through [at] along [axis] begins and ends to be on the side of a plane, or within the
     * other surfaces, and whether the room is there.
     */
    private inline fun WallSurface.cross(at: DoubleArray, axis: Int, use: (Double, Double, Boolean) -> Unit) {
        val moved = face.motion?.displacement(0.0) ?: 0.0
        var along = 0.0
        for (k in 0 until AXES) along += (at[k] - origin[k] - moved * way[k]) * direction[k]
        if (isPlane) {
            val slope = direction[axis]
            when {
                slope > 0 -> use(-along / slope, Double.POSITIVE_INFINITY, true)
                slope < 0 -> use(Double.NEGATIVE_INFINITY, -along / slope, true)
                along < 0 -> use(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, true)
            }
            return
        }
        var qq = 0.0
        var qu = 0.0
        var uu = 0.0
        for (k in 0 until AXES) {
            val q = at[k] - origin[k] - moved * way[k] - along * direction[k]
            val u = (if (k == axis) 1.0 else 0.0) - direction[axis] * direction[k]
            qq += q * q
            qu += q * u
            uu += u * u
        }
        val isRoom = side == RoomSide.INSIDE
        val square = qu * qu - uu * (qq - radius * radius)
        when {
            square > 0 && uu > 0 -> use((-qu - sqrt(square)) / uu, (-qu + sqrt(square)) / uu, isRoom)
            uu == 0.0 && qq < radius * radius -> use(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, isRoom)
            else -> use(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, isRoom)
        }
    }

    private companion object {
        const val LINES = 600
    }
}
