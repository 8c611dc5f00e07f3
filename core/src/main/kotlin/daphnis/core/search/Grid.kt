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
 * Two spheres can touch only if, at the start of the step, they are closer along each axis than the largest sum of radii plus twice the
 * [Reach]: the **range**. Across rows cells are at least one range wide, so that neighbouring rows suffice. Cells are
 * numbered along a row first, so cells side by side in a row are one run of memory; cutting a row finer costs nothing and
 * makes the runs fit the range more closely:
 *
 * ```
 *   slow axis ▲   ┌─┬─┬─┬─┬─┬─┬─┬─┐
 *             │   │ │▓│▓│▓│▓│▓│ │ │   ▓  runs that are searched for the sphere in ●
 *             │   ├─┼─┼─┼─┼─┼─┼─┼─┤
 *             │   │ │▓│▓│●│▓│▓│ │ │      cells ⅓ of a range along the row,
 *             │   ├─┼─┼─┼─┼─┼─┼─┼─┤      one range across
 *             │   │ │▓│▓│▓│▓│▓│ │ │
 *             │   └─┴─┴─┴─┴─┴─┴─┴─┘
 *             └────────────────────▶ row axis (memory)
 * ```
 *
 * Rows run along x unless images slide along another axis; then along that one, since the slide changes only where in a row to
 * look. Faces that are periodic continue with images, as many boxes away as the range demands, so a box thinner than the
 * range is searched right as well. All memory is kept from step to step. Not thread-safe.
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

    // Cell by slot; the complement of it where the range reaches over the edge of the grid.
    private var cellOfSlot = IntArray(0)
    private var cellOfIndex = IntArray(0)
    private var runs = 0

    private val layout = GridLayout()

    // Of the layout, for the row axis, the middle and the slow axis.
    private val cells = layout.cells
    private val span = layout.span
    private val periodic = layout.periodic

    // Rows within the range, as offsets in cells from the own row, which is in the middle; those after it lie ahead.
    private var rows = 0
    private var ownRow = 0
    private var rowOffset = IntArray(0)

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
        numberRows()
        sort(population)
    }

    /** Sets the runs that hold, once for each pair and image, the partners of [slot] in the whole population. @return number of runs */
    public fun forwardRuns(slot: Int): Int {
        if (cellOfSlot[slot] >= 0) return innerRuns(cellOfSlot[slot], slot + 1, ownRow)
        runs = 0
        val c0 = cellOfSlot[slot].inv() % cells[0]
        val row = cellOfSlot[slot].inv() / cells[0]
        val c1 = row % cells[1]
        val c2 = row / cells[1]
        // Rest of the own row: later slots, then cells ahead.
        val rowStart = row * cells[0]
        val last = minOf(c0 + span[0], cells[0] - 1)
        addRun(slot + 1, cellStart[rowStart + last + 1], 0)
        if (periodic[0]) addCells(rowStart, cells[0], c0 + span[0], 0, 0)
        for (d1 in 1..span[1]) addRow(c0, c1 + d1, c2)
        for (d2 in 1..span[2]) {
            for (d1 in -span[1]..span[1]) addRow(c0, c1 + d1, c2 + d2)
        }
        return runs
    }

    /** Sets the runs that hold every sphere and image that [slot] can touch; they hold [slot] itself too. @return number of runs */
    public fun allRuns(slot: Int): Int {
        val cell = cellOfSlot[slot]
        if (cell >= 0) return innerRuns(cell, cellStart[cell + rowOffset[0] - span[0]], 0)
        runs = 0
        val c0 = cell.inv() % cells[0]
        val row = cell.inv() / cells[0]
        val c1 = row % cells[1]
        val c2 = row / cells[1]
        for (d2 in -span[2]..span[2]) {
            for (d1 in -span[1]..span[1]) addRow(c0, c1 + d1, c2 + d2)
        }
        return runs
    }

    private fun isInner(c0: Int, c1: Int, c2: Int): Boolean =
        c0 >= span[0] && c0 < cells[0] - span[0] && c1 >= span[1] && c1 < cells[1] - span[1] && c2 >= span[2] && c2 < cells[2] - span[2]

    /** The runs of a [cell] whose whole range lies inside: rows [firstRow] and after, the first beginning at slot [firstSlot]. */
    private fun innerRuns(cell: Int, firstSlot: Int, firstRow: Int): Int {
        val start = cellStart
        val from = runFrom
        val to = runTo
        val image = runImage
        val reach = span[0]
        var k = 0
        var first = firstSlot
        for (r in firstRow until rows) {
            val middle = cell + rowOffset[r]
            if (r > firstRow) first = start[middle - reach]
            val end = start[middle + reach + 1]
            if (first < end) {
                from[k] = first
                to[k] = end
                image[k] = 0
                k++
            }
        }
        return k
    }

    /** Adds the range around [c0] in the row ([r1], [r2]), which may lie beyond a face. */
    private fun addRow(c0: Int, r1: Int, r2: Int) {
        var c1 = r1
        var c2 = r2
        var image1 = 0
        var image2 = 0
        if (c1 < 0 || c1 >= cells[1]) {
            if (!periodic[1]) return
            image1 = Math.floorDiv(c1, cells[1])
            c1 -= image1 * cells[1]
        }
        if (c2 < 0 || c2 >= cells[2]) {
            if (!periodic[2]) return
            image2 = Math.floorDiv(c2, cells[2])
            c2 -= image2 * cells[2]
        }
        val rowStart = (c2 * cells[1] + c1) * cells[0]
        var from = c0 - span[0]
        var to = c0 + span[0]
        if (image2 != 0 && layout.slides) {
            // The image row is displaced by s, so its spheres are looked for s earlier in the row.
            from -= ceil(maxOf(image2 * layout.slideLow, image2 * layout.slideHigh)).toInt()
            to -= floor(minOf(image2 * layout.slideLow, image2 * layout.slideHigh)).toInt()
        }
        if (from >= 0 && to < cells[0]) {
            val first = cellStart[rowStart + from]
            val end = cellStart[rowStart + to + 1]
            if (first < end) addRun(first, end, if (image1 or image2 == 0) 0 else code(0, image1, image2))
        } else if (periodic[0]) {
            addCells(rowStart, from, to, image1, image2)
        } else {
            addRun(cellStart[rowStart + maxOf(from, 0)], cellStart[rowStart + minOf(to, cells[0] - 1) + 1], code(0, image1, image2))
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

    private fun numberRows() {
        rows = (2 * span[1] + 1) * (2 * span[2] + 1)
        ownRow = rows / 2
        if (rowOffset.size < rows) rowOffset = IntArray(rows)
        while (runFrom.size < rows) growRuns()
        var r = 0
        for (d2 in -span[2]..span[2]) {
            for (d1 in -span[1]..span[1]) rowOffset[r++] = (d2 * cells[1] + d1) * cells[0]
        }
    }

    /** Counting sort. Stable, so the order within a cell is the order that the population came in. */
    private fun sort(population: Population) {
        val total = cells[0] * cells[1] * cells[2]
        if (order.size < n) {
            order = IntArray(n)
            cellOfSlot = IntArray(n)
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
        numberSlots()
    }

    private fun numberSlots() {
        val start = cellStart
        var cell = 0
        for (c2 in 0 until cells[2]) {
            for (c1 in 0 until cells[1]) {
                for (c0 in 0 until cells[0]) {
                    val number = if (isInner(c0, c1, c2)) cell else cell.inv()
                    for (slot in start[cell] until start[cell + 1]) cellOfSlot[slot] = number
                    cell++
                }
            }
        }
    }

    private companion object {
        const val INITIAL_RUNS = 64
    }
}
