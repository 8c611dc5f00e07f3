package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Images
import daphnis.core.population.Population
import kotlin.math.ceil
import kotlin.math.floor

/**
 * A regular grid that puts spheres in cell order and names, for each, the runs of slots in which every sphere lies that it can
 * touch within the step.
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
 * searched right as well. All memory is kept from step to step. Not thread-safe.
 */
public class Grid {
    /** Index in the population by slot. */
    public var order: IntArray = IntArray(0)
        private set

    /** First slot of run r; runs are set by [forwardRuns] and [allRuns]. */
    public var runFrom: IntArray = IntArray(INITIAL_RUNS)
        private set

    /** One past the last slot of run r. */
    public var runTo: IntArray = IntArray(INITIAL_RUNS)
        private set

    /** Image of the spheres in run r, see [Images]. */
    public var runImage: IntArray = IntArray(INITIAL_RUNS)
        private set

    /** The images of this step. */
    public val images: Images = Images()

    private var n = 0
    private var cellStart = IntArray(0)

    private var cellOfIndex = IntArray(0)
    private var runs = 0

    private val layout = GridLayout()

    // Of the layout, for the row axis, the middle and the slow axis.
    private val cells = layout.cells
    private val periodic = layout.periodic

    // The box of cells at hand along the same three axes; may reach beyond the faces of periodic axes.
    private val least = IntArray(3)
    private val most = IntArray(3)

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

    /**
     * Sets the runs that hold, once for each pair and image, the partners that sphere [slot] can touch on its way in this step, from its
     * place ([x], [y], [z]) at the start by ([wayX], [wayY], [wayZ]). Only at the start, when nobody has collided.
     *
     * @return number of runs
     */
    public fun forwardRuns(slot: Int, x: Double, y: Double, z: Double, wayX: Double, wayY: Double, wayZ: Double, radius: Double): Int {
        runs = 0
        cover(x, y, z, wayX, wayY, wayZ, radius)
        val c1 = layout.cellAt(layout.pick(1, x, y, z), 1)
        val c2 = layout.cellAt(layout.pick(2, x, y, z), 2)
        // Rest of the own row: later slots, then cells ahead; then the rows ahead, those of the own layer and those of the layers above.
        val rowStart = (c2 * cells[1] + c1) * cells[0]
        addRun(slot + 1, cellStart[rowStart + minOf(most[0], cells[0] - 1) + 1], 0)
        if (periodic[0]) addCells(rowStart, cells[0], most[0], 0, 0)
        for (row in c1 + 1..most[1]) addRow(row, c2)
        for (layer in c2 + 1..most[2]) {
            for (row in least[1]..most[1]) addRow(row, layer)
        }
        return runs
    }

    /**
     * Sets the runs that hold every sphere and image that a sphere can touch on the rest of its way, from its place ([x], [y], [z]) now by
     * ([wayX], [wayY], [wayZ]); they hold the sphere itself too.
     *
     * @return number of runs
     */
    public fun allRuns(x: Double, y: Double, z: Double, wayX: Double, wayY: Double, wayZ: Double, radius: Double): Int {
        runs = 0
        cover(x, y, z, wayX, wayY, wayZ, radius)
        for (layer in least[2]..most[2]) {
            for (row in least[1]..most[1]) addRow(row, layer)
        }
        return runs
    }

    private fun cover(x: Double, y: Double, z: Double, wayX: Double, wayY: Double, wayZ: Double, radius: Double) {
        for (k in 0..2) {
            val from = layout.pick(k, x, y, z)
            val to = from + layout.pick(k, wayX, wayY, wayZ)
            val margin = radius + layout.margin[k]
            least[k] = layout.cellToward(Math.min(from, to) - margin, k)
            most[k] = layout.cellToward(Math.max(from, to) + margin, k)
        }
    }

    /** Adds the cells at hand in the row ([r1], [r2]), which may lie beyond a face. */
    private fun addRow(r1: Int, r2: Int) {
        var c1 = r1
        var c2 = r2
        var image1 = 0
        var image2 = 0
        if (c1 < 0 || c1 >= cells[1]) {
            image1 = Math.floorDiv(c1, cells[1])
            c1 -= image1 * cells[1]
        }
        if (c2 < 0 || c2 >= cells[2]) {
            image2 = Math.floorDiv(c2, cells[2])
            c2 -= image2 * cells[2]
        }
        val rowStart = (c2 * cells[1] + c1) * cells[0]
        var from = least[0]
        var to = most[0]
        if (image2 != 0 && layout.slides) {
            // The image row is displaced by s, so its spheres are looked for s earlier in the row.
            from -= ceil(maxOf(image2 * layout.slideLow, image2 * layout.slideHigh)).toInt()
            to -= floor(minOf(image2 * layout.slideLow, image2 * layout.slideHigh)).toInt()
        }
        if (from >= 0 && to < cells[0]) {
            addRun(cellStart[rowStart + from], cellStart[rowStart + to + 1], if (image1 or image2 == 0) 0 else code(0, image1, image2))
        } else {
            addCells(rowStart, from, to, image1, image2)
        }
    }

    /** Adds the cells [from]..[to] of a periodic row, split where an image begins. */
    private fun addCells(rowStart: Int, from: Int, to: Int, image1: Int, image2: Int) {
        var c = from
        while (c <= to) {
            val image0 = Math.floorDiv(c, cells[0])
            val end = minOf(to, (image0 + 1) * cells[0] - 1)
            val base = rowStart - image0 * cells[0]
            addRun(cellStart[base + c], cellStart[base + end + 1], code(image0, image1, image2))
            c = end + 1
        }
    }

    private fun addRun(from: Int, to: Int, image: Int) {
        if (from >= to) return
        if (runs == runFrom.size) growRuns()
        runFrom[runs] = from
        runTo[runs] = to
        runImage[runs] = image
        runs++
    }

    private fun growRuns() {
        runFrom = runFrom.copyOf(runFrom.size * 2)
        runTo = runTo.copyOf(runTo.size * 2)
        runImage = runImage.copyOf(runImage.size * 2)
    }

    private fun code(image0: Int, image1: Int, image2: Int): Int =
        ((image0 and 0xff) shl (8 * layout.axes[0])) or ((image1 and 0xff) shl (8 * layout.axes[1])) or ((image2 and 0xff) shl (8 * layout.axes[2]))

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

    private companion object {
        const val INITIAL_RUNS = 64
    }
}
