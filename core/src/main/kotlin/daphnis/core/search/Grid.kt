package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Images
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
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
public class Grid(sort: GridSort = GridSort.COUNTING) {
    private val sorting = if (sort == GridSort.ROW_LOCKS) RowLockedSort() else CountingSort()
    private val sorted = CellOrder()

    /** Index in the population by slot. */
    public val order: IntArray get() = sorted.order

    /** The images of this step. */
    public val images: Images = Images()

    internal val layout = GridLayout()

    /** First slot of cell c; entry c + 1 is one past its last. */
    internal val cellStart: IntArray get() = sorted.start

    // Of the layout, for the row axis, the middle and the slow axis.
    private val cells = layout.cells

    /** Cells along [axis]. */
    public fun cellsAlong(axis: Int): Int = cells[layout.axes.indexOf(axis)]

    /** Width of a cell along [axis]. */
    public fun cellWidth(axis: Int): Double = layout.width(layout.axes.indexOf(axis))

    /**
     * How far apart along [axis] two spheres, both at the start of the step, can be at most if one looks through the cell of the other at any
     * moment of the step.
     */
    public fun sight(axis: Int): Double {
        val k = layout.axes.indexOf(axis)
        // Out to the end of the way, the radii, and back from where the other may have gone to; and a cell on top, of which a part may be seen.
        return 2 * layout.margin[k] + layout.width(k)
    }

    /**
     * Sorts [population] into cells for a step from [time] of [duration] in which nobody goes farther than [reach].
     *
     * @param reach bound along x, y, z; zeros find what touches at the start
     * @param loop runs the loops over spheres
     * @throws IllegalArgumentException when a periodic box is so thin against the range that images beyond ±[GridLayout.MOST_BOXES] would matter
     */
    public fun build(population: Population, boundary: BoundaryConditions, time: Double, duration: Double, reach: DoubleArray, loop: RangeLoop = InlineLoop) {
        images.prepare(boundary, time)
        layout.prepare(population, boundary, images, duration, reach, loop)
        sorting.sort(population, layout, sorted, loop)
    }
}
