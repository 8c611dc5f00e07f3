package daphnis.app.live

import daphnis.core.scenario.SurfaceCurve
import kotlin.math.sqrt

/**
 * What is drawn of [walls]: the edges of the box, and curves on surfaces. Each piece of a surface that is in the room, between [low] and [high] and on the right side of all other
 * surfaces.
 */
internal class WallLines(private val walls: SeenWalls, private val low: DoubleArray, private val high: DoubleArray) {
    private val ends = ArrayList<DoubleArray>()
    private val tolerance = TOLERANCE * sqrt((0 until AXES).sumOf { (high[it] - low[it]) * (high[it] - low[it]) })
    private val corners = List(8) { n -> DoubleArray(AXES) { if (n shr it and 1 == 0) low[it] else high[it] } }

    /** Pieces of straight lines, two points each. */
    fun pieces(): List<DoubleArray> {
        edges()
        walls.surfaces.forEachIndexed { k, it ->
            for (curve in it.curves(corners, walls.displacement(k))) add(k, curve)
        }
        return ends
    }

    /** Along each axis with faces, at the faces of the others, or in the middle of those that are open. */
    private fun edges() {
        for (axis in 0 until AXES) {
            if (!walls.isFace(axis)) continue
            val (one, other) = (0 until AXES).filter { it != axis }
            for (a in sides(one)) {
                for (b in sides(other)) {
                    val from = DoubleArray(AXES)
                    from[axis] = low[axis]
                    from[one] = a
                    from[other] = b
                    ends += from
                    ends += from.copyOf().also { it[axis] = high[axis] }
                }
            }
        }
    }

    private fun sides(axis: Int): List<Double> = when {
        walls.isFace(axis) -> listOf(low[axis], high[axis])
        walls.extent(axis) != null -> emptyList()
        else -> listOf((low[axis] + high[axis]) / 2)
    }

    /** What of the [curve] on the surface [k] is in the room. */
    private fun add(k: Int, curve: SurfaceCurve) {
        val at = curve.at::apply
        var begin = -1
        for (n in 0..PIECES) {
            val isSeen = n < PIECES && isInRoom(k, at((n + 0.5) / PIECES))
            if (isSeen && begin < 0) begin = n
            if (begin >= 0 && (!isSeen || !curve.isStraight)) {
                ends += at(begin.toDouble() / PIECES)
                ends += at((if (isSeen) n + 1.0 else n.toDouble()) / PIECES)
                begin = -1
            }
        }
    }

    private fun isInRoom(k: Int, at: DoubleArray): Boolean =
        (0 until AXES).all { at[it] >= low[it] - tolerance && at[it] <= high[it] + tolerance } &&
            walls.surfaces.indices.all { it == k || walls.distance(it, at) >= -tolerance }

    private companion object {
        const val AXES = 3
        const val PIECES = 64

        /** Of the diagonal of what is seen. */
        const val TOLERANCE = 1e-9
    }
}
