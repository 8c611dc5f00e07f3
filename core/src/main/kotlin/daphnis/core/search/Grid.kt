package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.prepare
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns
import daphnis.core.space.Images

/**
 * A regular grid that puts spheres in cell order. For each sphere, [CellRuns] then gives the runs of slots that hold
 * every sphere which it can touch within the step.
 *
 * The path of the sphere itself until the end of the step is known: without a collision it is straight. The positions
 * of other spheres are known only up to the [Reach]. So a sphere can touch only spheres that were, at the start of the
 * step, no farther from its path along each axis than its radius, the largest radius and the reach together. Cells are
 * numbered along a row first, so adjacent cells in a row are one run of memory:
 *
 * ```
 *   slow axis ▲   ┌─┬─┬─┬─┬─┬─┬─┬─┐
 *             │   │ │▓│▓│▓│▓│▓│▓│ │   ▓  runs that are searched for the sphere at ● on its path to ○
 *             │   ├─┼─┼─┼─┼─┼─┼─┼─┤
 *             │   │ │▓│▓│●│▓│○│▓│ │
 *             │   ├─┼─┼─┼─┼─┼─┼─┼─┤
 *             │   │ │▓│▓│▓│▓│▓│▓│ │
 *             │   └─┴─┴─┴─┴─┴─┴─┴─┘
 *             └────────────────────▶ row axis (memory)
 * ```
 *
 * Rows run along x unless images slide along another axis. Then rows run along that axis, since the slide changes only
 * the place in a row that is searched. Beyond periodic faces the grid continues with images, as many boxes away as the
 * path requires, so a box thinner than the path is searched correctly as well.
 *
 * Spheres of very different sizes are kept apart: each class of sizes ([SizeClasses]) has its own cells, one class
 * after the other in memory, and the cells of each class are searched no farther than that class requires. A single
 * class is the paper's grid.
 *
 * All memory is kept from step to step. Once [build] has returned, any number of threads may read, each through
 * its own [CellRuns].
 */
public class Grid @JvmOverloads constructor(sort: GridSort = GridSort.COUNTING) {
    private val sorting = if (sort == GridSort.ROW_LOCKS) RowLockedSort() else CountingSort()
    private val sorted = CellOrder()

    /** Index in the population by slot. */
    public val order: IntArray get() = sorted.order

    /** The images of this step. */
    public val images: Images = Images()

    internal val levels = GridLevels()

    /** By how much the radii of the spheres given to [build] are larger than those of the rows that are searched for. */
    internal var swelling: Double = 1.0

    /** How much larger than it is a sphere counts that searches after a collision. */
    internal var outlook: Double = 1.0

    /** First slot of cell c; entry c + 1 is one past its last. */
    internal val cellStart: IntArray get() = sorted.start

    /** Number of classes of sizes, each with its own cells; [of] counts them from the smallest. */
    public val classes: Int get() = levels.count

    /** Largest radius in class [of]. */
    public fun largestRadius(of: Int): Double = levels[of].largest

    /** Cells along [axis]. */
    @JvmOverloads
    public fun cellsAlong(axis: Int, of: Int = 0): Int = levels[of].cells[levels[of].axes.indexOf(axis)]

    /** Width of a cell along [axis]. */
    @JvmOverloads
    public fun cellWidth(axis: Int, of: Int = 0): Double = levels[of].width[levels[of].axes.indexOf(axis)]

    /**
     * The largest distance along [axis], at the start of the step, of two spheres of which one searches the cell of the
     * other at any moment of the step.
     */
    public fun sight(axis: Int): Double {
        val top = levels.count - 1
        var most = 0.0
        for (level in 0..top) most = maxOf(most, sight(axis, top, level))
        return most
    }

    /** The same for spheres of [radius] and [otherRadius]. */
    public fun sight(axis: Int, radius: Double, otherRadius: Double): Double {
        val a = levels.of(radius)
        val b = levels.of(otherRadius)
        return maxOf(sight(axis, a, b), sight(axis, b, a))
    }

    private fun sight(axis: Int, looking: Int, lookedAt: Int): Double {
        val k = levels[0].axes.indexOf(axis)
        // Out to the end of the path, the radii, and back from where the other sphere may have gone; plus one cell, of
        // which a part may be searched.
        return levels[looking].margin[k] + levels[lookedAt].margin[k] + levels[lookedAt].width[k]
    }

    /**
     * Sorts [population] into cells for a step from [time] of [duration] in which no sphere goes farther than [reach].
     *
     * @param reach bound along x, y, z; with zeros, spheres that touch at the start are found
     * @param loop runs the loops over spheres
     * @param structure whether sizes are kept apart
     * @param middle for spheres that lie in a part of a periodic box only: along x, y, z about the middle of that part,
     *   NaN along axes on which they may lie anywhere. Cells are then laid over that part alone; that affects only time
     *   and memory
     * @throws IllegalArgumentException when a periodic box is so thin compared with the range that images beyond
     *   ±[ImageRange.MOST_BOXES] would matter
     */
    @JvmOverloads
    public fun build(
        population: SphereColumns,
        boundary: BoundaryConditions,
        time: Double,
        duration: Double,
        reach: DoubleArray,
        loop: RangeLoop = InlineLoop,
        structure: SearchStructure = SearchStructure.AUTO,
        middle: DoubleArray = WHOLE,
    ) {
        images.prepare(boundary, time)
        levels.prepare(population, boundary, images, duration, reach, structure, loop, middle)
        sorting.sort(population, levels, sorted, loop)
    }

    internal companion object {
        /** Spheres may lie anywhere. */
        val WHOLE: DoubleArray = DoubleArray(3) { Double.NaN }
    }
}
