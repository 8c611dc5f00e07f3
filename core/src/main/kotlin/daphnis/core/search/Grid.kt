package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Images
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population

/**
 * A regular grid that puts spheres in cell order; [CellRuns] then names, for each, the runs of slots in which every
 * sphere lies that it can touch within the step.
 *
 * Where a sphere itself goes until the end of the step, if nothing happens to it, is known: a straight way. Where
 * others may be is known only up to the [Reach]. So it can touch only spheres that were, at the start of the step, no
 * farther from its way along each axis than its radius, the largest radius and the reach together. Cells are numbered
 * along a row first, so cells side by side in a row are one run of memory:
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
 * Rows run along x unless images slide along another axis; then along that one, since the slide changes only where in a
 * row to look. Faces that are periodic continue with images, as many boxes away as the way demands, so a box thinner
 * than that is searched right as well.
 *
 * Spheres of very different sizes are told apart: each class of sizes ([SizeClasses]) has cells of its own, one class
 * after the other in memory, and a sphere looks through those of every class no farther than that class demands. One
 * class is the paper's grid.
 *
 * All memory is kept from step to step. Once [build] has returned, any number of threads may read, each through
 * its own [CellRuns].
 */
public class Grid(sort: GridSort = GridSort.COUNTING) {
    private val sorting = if (sort == GridSort.ROW_LOCKS) RowLockedSort() else CountingSort()
    private val sorted = CellOrder()

    /** Index in the population by slot. */
    public val order: IntArray get() = sorted.order

    /** The images of this step. */
    public val images: Images = Images()

    internal val levels = GridLevels()

    /** First slot of cell c; entry c + 1 is one past its last. */
    internal val cellStart: IntArray get() = sorted.start

    /** Number of classes of sizes, each with cells of its own; [of] takes them from the smallest. */
    public val classes: Int get() = levels.count

    /** Largest radius in class [of]. */
    public fun largestRadius(of: Int): Double = levels[of].largest

    /** Cells along [axis]. */
    public fun cellsAlong(axis: Int, of: Int = 0): Int = levels[of].cells[levels[of].axes.indexOf(axis)]

    /** Width of a cell along [axis]. */
    public fun cellWidth(axis: Int, of: Int = 0): Double = levels[of].widths[levels[of].axes.indexOf(axis)]

    /**
     * How far apart along [axis] two spheres, both at the start of the step, can be at most if one looks through the
     * cell of the other at any moment of the step.
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
        // Out to the end of the way, the radii, and back from where the other may have gone to; and a cell on top, of
        // which a part may be seen.
        return levels[looking].margin[k] + levels[lookedAt].margin[k] + levels[lookedAt].widths[k]
    }

    /**
     * Sorts [population] into cells for a step from [time] of [duration] in which nobody goes farther than [reach].
     *
     * @param reach bound along x, y, z; zeros find what touches at the start
     * @param loop runs the loops over spheres
     * @param structure whether sizes are told apart
     * @throws IllegalArgumentException when a periodic box is so thin against the range that images beyond
     *   ±[ImageRange.MOST_BOXES] would matter
     */
    public fun build(
        population: Population,
        boundary: BoundaryConditions,
        time: Double,
        duration: Double,
        reach: DoubleArray,
        loop: RangeLoop = InlineLoop,
        structure: SearchStructure = SearchStructure.AUTO,
    ) {
        images.prepare(boundary, time)
        levels.prepare(population, boundary, images, duration, reach, structure, loop)
        sorting.sort(population, levels, sorted, loop)
    }
}
