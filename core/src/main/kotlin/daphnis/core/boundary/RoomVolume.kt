package daphnis.core.boundary

import daphnis.core.wall.Wall

/**
 * The volume, or in the plane the area, of what [surfaces] leave of a [box]: exact for a single cylinder or sphere that
 * lies in the box, and elsewhere to some 1e-4 of the box, by the lengths of parallel lines in the room.
 */
internal class RoomVolume(private val box: Box, private val surfaces: List<Wall>) {
    private val isPlane = box.space.isPlane

    /** Along which lines are followed. */
    private val along = if (isPlane) 1 else 2
    private val point = DoubleArray(AXES)
    private val ends = DoubleArray(2)

    fun value(): Double = exact() ?: byLines()

    private fun exact(): Double? {
        val only = surfaces.singleOrNull() ?: return null
        val axes = 0 until box.space.dimensions
        val isClosed = axes.all { only.isSameAlong(it) || only.encloses(it, box.lower(it), box.upper(it)) }
        return if (isClosed) only.volume(axes) { box.length(it) } else null
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
        val holes = ArrayList<Pair<Double, Double>>(0)
        for (surface in surfaces) {
            surface.cut(point, along, ends)
            if (surface.isRoomWithin) {
                from = maxOf(from, ends[0])
                to = minOf(to, ends[1])
            } else {
                holes += Pair(ends[0], ends[1])
            }
        }
        if (to <= from) return 0.0
        var free = to - from
        var done = from
        for ((first, last) in holes.sortedBy { it.first }) {
            val end = minOf(last, to)
            free -= maxOf(0.0, end - maxOf(first, done))
            done = maxOf(done, end)
        }
        return free
    }

    private companion object {
        const val LINES = 600
    }
}
