package daphnis.actors.region

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.search.Grid
import kotlin.math.abs

/**
 * Which region owns which slot, and which regions are neighbours: two regions are neighbours when a sphere of one can
 * see a sphere of the other at any moment of the step. Written by the coordinator between steps; read by all.
 */
public class RegionMap(public val layout: RegionLayout) {
    /** Number of regions. */
    public val count: Int = layout.count

    private var regionOf = IntArray(0)
    private var size = 0
    private val low = DoubleArray(count * AXES)
    private val high = DoubleArray(count * AXES)
    private val neighbours = Array(count) { BooleanArray(count) }

    /** The region that owns [slot]. */
    public fun regionOf(slot: Int): Int = regionOf[slot]

    /** Whether a sphere of region [a] may see one of region [b]; a region is its own neighbour. */
    public fun areNeighbours(a: Int, b: Int): Boolean = neighbours[a][b]

    /** Calls [action] with the stretches of slots, from until to, that [region] owns. */
    public fun forEachStretch(region: Int, action: (Int, Int) -> Unit) {
        var from = 0
        while (from < size) {
            if (regionOf[from] != region) {
                from++
                continue
            }
            var to = from + 1
            while (to < size && regionOf[to] == region) to++
            action(from, to)
            from = to
        }
    }

    /** Divides the spheres of [rows], which are at their places at the start of the step. */
    public fun prepare(rows: StepRows, grid: Grid, boundary: BoundaryConditions) {
        size = rows.size
        if (regionOf.size < size) regionOf = IntArray(size)
        when (layout) {
            is RegionLayout.Stretches -> for (slot in 0 until size) {
                regionOf[slot] =
                    (slot.toLong() * count / size).toInt()
            }
            is RegionLayout.Blocks -> divide(rows, layout)
        }
        measure(rows)
        for (a in 0 until count) {
            for (b in 0..a) {
                val near = a == b || areNear(a, b, grid, boundary)
                neighbours[a][b] = near
                neighbours[b][a] = near
            }
        }
    }

    private fun divide(rows: StepRows, blocks: RegionLayout.Blocks) {
        val number = intArrayOf(blocks.x, blocks.y, blocks.z)
        val least = DoubleArray(AXES) { Double.POSITIVE_INFINITY }
        val most = DoubleArray(AXES) { Double.NEGATIVE_INFINITY }
        for (slot in 0 until size) {
            for (axis in 0 until AXES) {
                least[axis] = Math.min(least[axis], rows.state[slot * STRIDE + axis])
                most[axis] = Math.max(most[axis], rows.state[slot * STRIDE + axis])
            }
        }
        for (slot in 0 until size) {
            var region = 0
            for (axis in 0 until AXES) {
                val extent = most[axis] - least[axis]
                val share = if (extent > 0) (rows.state[slot * STRIDE + axis] - least[axis]) / extent else 0.0
                region = region * number[axis] + (share * number[axis]).toInt().coerceAtMost(number[axis] - 1)
            }
            regionOf[slot] = region
        }
    }

    private fun measure(rows: StepRows) {
        low.fill(Double.POSITIVE_INFINITY)
        high.fill(Double.NEGATIVE_INFINITY)
        for (slot in 0 until size) {
            val p = regionOf[slot] * AXES
            for (axis in 0 until AXES) {
                val x = rows.state[slot * STRIDE + axis]
                low[p + axis] = Math.min(low[p + axis], x)
                high[p + axis] = Math.max(high[p + axis], x)
            }
        }
    }

    private fun areNear(a: Int, b: Int, grid: Grid, boundary: BoundaryConditions): Boolean {
        val shear = boundary.shear
        for (axis in 0 until AXES) {
            // Images that slide may be anywhere along the slide.
            if (axis == shear?.slideAxis) continue
            val gap = maxOf(low[b * AXES + axis] - high[a * AXES + axis], low[a * AXES + axis] - high[b * AXES + axis])
            val sight = grid.sight(axis)
            if (gap <= sight) continue
            if (!boundary.hasImages(axis)) return false
            val length = boundary.box.length(axis)
            val span = maxOf(high[b * AXES + axis] - low[a * AXES + axis], high[a * AXES + axis] - low[b * AXES + axis])
            if (abs(length - span) > sight && length - span > 0) return false
        }
        return true
    }

    private companion object {
        const val AXES = 3
    }
}
