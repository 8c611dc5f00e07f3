package daphnis.core.search

import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population

/** How a [Grid] sorts spheres into cells. The result is the same: by cell, within a cell by the order that the population came in. */
public enum class GridSort {
    /** Counting sort; in parallel each worker counts a part of the population and the counts are put together. */
    COUNTING,

    /** The paper's: every worker hangs spheres into the lists of their cells and holds the lock of the row meanwhile. */
    ROW_LOCKS,
}

/** The result of a sort, and the arrays for it, which keep their size from step to step. */
internal class CellOrder {
    /** Index in the population by slot. */
    var order = IntArray(0)

    /** First slot of cell c; entry c + 1 is one past its last. */
    var start = IntArray(0)

    /** Cell by index in the population. */
    var cellOf = IntArray(0)

    fun reserve(spheres: Int, cells: Int) {
        if (order.size < spheres) {
            order = IntArray(spheres)
            cellOf = IntArray(spheres)
        }
        // One entry more than needed at either end, see CountingSort.
        if (start.size < cells + 2) start = IntArray(cells + cells / 4 + 2)
    }
}

internal interface CellSort {
    fun sort(population: Population, levels: GridLevels, into: CellOrder, loop: RangeLoop)
}

/** Cells of the spheres [from] until [to] into [CellOrder.cellOf]. */
internal fun findCells(population: Population, levels: GridLevels, into: CellOrder, from: Int, to: Int) {
    val a = levels[0].coordinate(population, 0)
    val b = levels[0].coordinate(population, 1)
    val c = levels[0].coordinate(population, 2)
    val several = levels.count > 1
    var layout = levels[0]
    val cellOf = into.cellOf
    for (k in from until to) {
        if (several) layout = levels[levels.of(population.radius[k])]
        val c0 = layout.cellAt(a[k], 0)
        val c1 = layout.cellAt(b[k], 1)
        val c2 = layout.cellAt(c[k], 2)
        cellOf[k] = layout.firstCell + (c2 * layout.cells[1] + c1) * layout.cells[0] + c0
    }
}
