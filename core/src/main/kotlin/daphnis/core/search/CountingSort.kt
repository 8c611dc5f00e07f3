package daphnis.core.search

import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns

/** Counting sort by cell, see [CellCounting]. */
internal class CountingSort : CellSort {
    private val counting = CellCounting()

    override fun sort(population: SphereColumns, levels: GridLevels, into: CellOrder, loop: RangeLoop) {
        counting.sort(population.size, levels.cellCount, into, loop) { from, to ->
            findCells(population, levels, into, from, to)
        }
    }
}
