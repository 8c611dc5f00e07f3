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
    fun sort(population: Population, layout: GridLayout, into: CellOrder, loop: RangeLoop)
}

/** Cells of the spheres [from] until [to] into [CellOrder.cellOf]. */
internal fun findCells(population: Population, layout: GridLayout, into: CellOrder, from: Int, to: Int) {
    val a = layout.coordinate(population, 0)
    val b = layout.coordinate(population, 1)
    val c = layout.coordinate(population, 2)
    val n0 = layout.cells[0]
    val n1 = layout.cells[1]
    val cellOf = into.cellOf
    for (k in from until to) {
        val c0 = layout.cellAt(a[k], 0)
        val c1 = layout.cellAt(b[k], 1)
        val c2 = layout.cellAt(c[k], 2)
        cellOf[k] = (c2 * n1 + c1) * n0 + c0
    }
}
