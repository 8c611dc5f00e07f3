package daphnis.core.format

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.at
import daphnis.core.boundary.inside
import kotlin.math.floor

/** A box centred on the origin that repeats along the axes marked in [periodic]; images may be displaced by [offset]. */
internal class FoldedCell(
    private val lengths: DoubleArray,
    private val periodic: BooleanArray,
    private val offset: Double,
    private val normalAxis: Int,
    private val slideAxis: Int,
) {
    /**
     * Moves the [places], `[axis][k]`, into the box.
     *
     * @return the boxes that each was moved by, `[axis][k]`; null when all were inside
     */
    fun fold(places: Array<DoubleArray>): Array<IntArray>? {
        var boxes: Array<IntArray>? = null
        // A sphere that comes back through a sliding face is displaced along it, so that face is first.
        for (axis in listOf(normalAxis) + (0..2).filter { it != normalAxis }) {
            if (!periodic[axis] || lengths[axis].isNaN()) continue
            val half = lengths[axis] / 2
            for (k in places[axis].indices) {
                val v = places[axis][k]
                // The upper face is where a file may put what daphnis puts at the lower one.
                if (v >= -half && v <= half) continue
                val crossed = floor((v + half) / lengths[axis])
                places[axis][k] = inside(v - crossed * lengths[axis], -half, half)
                if (axis == normalAxis) places[slideAxis][k] -= crossed * offset
                val sum = boxes ?: Array(3) { IntArray(places[0].size) }.also { boxes = it }
                sum[axis][k] += crossed.toInt()
            }
        }
        return boxes
    }

    companion object {
        /** That of [snapshot]. */
        fun of(snapshot: Snapshot): FoldedCell = with(snapshot) {
            FoldedCell(lengths, periodic, shearOffset, normalAxis, slideAxis)
        }

        /** That of [boundary] at [time]. */
        fun of(boundary: BoundaryConditions, time: Double): FoldedCell = with(boundary.at(time)) {
            FoldedCell(
                DoubleArray(3) { box.length(it) },
                BooleanArray(3) { repeats(it) },
                shear?.offset(time) ?: 0.0,
                shear?.normalAxis ?: 1,
                shear?.slideAxis ?: 0,
            )
        }
    }
}
