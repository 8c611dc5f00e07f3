package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Images
import daphnis.core.population.Population

/**
 * A regular grid that puts spheres in cell order; [CellRuns] then names, for each, the runs of slots in which every sphere lies that it
 * can touch within the step.
 *
 * Where a sphere itself goes until the end of the step, if nothing happens to it, is known: a straight way. Where others may be is known
 * only up to the [Reach]. So it can touch only spheres that were, at the start of the step, no farther from its way along each axis than its
 * radius, the largest radius and the reach together. Cells are numbered along a row first, so cells side by side in a row are one run of
 * memory:
 *
 * ```
 *   slow axis ▲   ┌─┬─┬─┬─┬─┬─┬─┬─┐
 *             │   │ │▓│▓│▓│▓│▓│▓│ │   ▓  runs that are searched for the sphere at ● on its way to ○
 *             │   ├─┼─┼─┼─┼─┼─┼─┼─┤
 *             │   │ │▓│▓│●│▓│○│▓│ │
 *             │   ├─┼─┼─┼─┼─┼─┼─┼─┤
 *             │   │ │▓│▓│▓│▓│▓│▓│ │
 *             │   └─┴─┴─┴─┴─┴─┴─┴─┘
 *             └────────────────────▶ row axis (memory)
 * ```
 *
 * Rows run along x unless images slide along another axis; then along that one, since the slide changes only where in a row to
 * look. Faces that are periodic continue with images, as many boxes away as the way demands, so a box thinner than that is
 * searched right as well. All memory is kept from step to step. Once [build] has returned, any number of threads may read, each through
 * its own [CellRuns].
 */
public class Grid {
    /** Index in the population by slot. */
    public var order: IntArray = IntArray(0)
        private set

    /** The images of this step. */
    public val images: Images = Images()

    internal val layout = GridLayout()

    /** First slot of cell c; entry c + 1 is one past its last. */
    internal var cellStart: IntArray = IntArray(0)
        private set

    private var n = 0
    private var cellOfIndex = IntArray(0)

    // Of the layout, for the row axis, the middle and the slow axis.
    private val cells = layout.cells

    /** Cells along [axis]. */
    public fun cellsAlong(axis: Int): Int = cells[layout.axes.indexOf(axis)]

    /** Width of a cell along [axis]. */
    public fun cellWidth(axis: Int): Double = layout.width(layout.axes.indexOf(axis))

    /**
     * Sorts [population] into cells for a step from [time] of [duration] in which nobody goes farther than [reach].
     *
     * @param reach bound along x, y, z; zeros find what touches at the start
     * @throws IllegalArgumentException when a periodic box is so thin against the range that images beyond ±[GridLayout.MOST_BOXES] would matter
     */
    public fun build(population: Population, boundary: BoundaryConditions, time: Double, duration: Double, reach: DoubleArray) {
        n = population.size
        images.prepare(boundary, time)
        layout.prepare(population, boundary, images, duration, reach)
        sort(population)
    }

    /** Counting sort. Stable, so the order within a cell is the order that the population came in. */
    private fun sort(population: Population) {
        val total = cells[0] * cells[1] * cells[2]
        if (order.size < n) {
            order = IntArray(n)
            cellOfIndex = IntArray(n)
        }
        // One entry more than needed at either end: counts go to c + 2, become starts at c + 1, end up as starts at c.
        if (cellStart.size < total + 2) cellStart = IntArray(total + total / 4 + 2)
        val start = cellStart
        start.fill(0, 0, total + 2)
        val a = layout.coordinate(population, 0)
        val b = layout.coordinate(population, 1)
        val c = layout.coordinate(population, 2)
        val n0 = cells[0]
        val n1 = cells[1]
        for (k in 0 until n) {
            val c0 = layout.cellAt(a[k], 0)
            val c1 = layout.cellAt(b[k], 1)
            val c2 = layout.cellAt(c[k], 2)
            val cell = (c2 * n1 + c1) * n0 + c0
            cellOfIndex[k] = cell
            start[cell + 2]++
        }
        for (cell in 2..total) start[cell] += start[cell - 1]
        for (k in 0 until n) order[start[cellOfIndex[k] + 1]++] = k
    }
}
