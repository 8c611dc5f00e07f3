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
