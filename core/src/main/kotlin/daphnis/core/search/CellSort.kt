package daphnis.core.search

import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns

/** Puts spheres in cell order; see [GridSort] for the methods. */
internal interface CellSort {
    fun sort(population: SphereColumns, levels: GridLevels, into: CellOrder, loop: RangeLoop)
}

/** Writes the cells of the spheres [from] until [to] into [CellOrder.cellOf]. */
internal fun findCells(population: SphereColumns, levels: GridLevels, into: CellOrder, from: Int, to: Int) {
    val a = levels[0].coordinate(population, 0)
    val b = levels[0].coordinate(population, 1)
    val c = levels[0].coordinate(population, 2)
    val several = levels.count > 1
    var layout = levels[0]
    val cellOf = into.cellOf
    for (k in from until to) {
        if (several) layout = levels[levels.of(population.radius[k])]
        val c0 = layout.inMemory(layout.cellAt(a[k], 0), 0)
        val c1 = layout.inMemory(layout.cellAt(b[k], 1), 1)
        val c2 = layout.inMemory(layout.cellAt(c[k], 2), 2)
        cellOf[k] = layout.firstCell + (c2 * layout.cells[1] + c1) * layout.cells[0] + c0
    }
}

/**
 * How a [Grid] sorts spheres into cells. The result is the same: by cell, and within a cell by the previous order of
 * the population.
 */
public enum class GridSort {
    /** Counting sort; in parallel each worker counts a part of the population, and the counts are combined. */
    COUNTING,

    /**
     * The paper's method: every worker hangs spheres into the lists of their cells while it holds the lock of the row.
     */
    ROW_LOCKS,
}

/** Counting sort by cell, see [CellCounting]. */
internal class CountingSort : CellSort {
    private val counting = CellCounting()

    override fun sort(population: SphereColumns, levels: GridLevels, into: CellOrder, loop: RangeLoop) {
        counting.sort(population.size, levels.cellCount, into, loop) { from, to ->
            findCells(population, levels, into, from, to)
        }
    }
}
