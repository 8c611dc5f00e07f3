package daphnis.core.search

import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns

/**
 * The paper's parallel grid: cells are linked lists, every worker takes spheres and hangs each into the list of its
 * cell while it holds the lock of that row. The lists are then written out in order of cells, sorted by index, so that
 * the result does not depend on which worker came first.
 */
internal class RowLockedSort : CellSort {
    private var head = IntArray(0)
    private var next = IntArray(0)
    private var rowCount = IntArray(0)
    private var locks = arrayOf<Any>()

    override fun sort(population: SphereColumns, levels: GridLevels, into: CellOrder, loop: RangeLoop) {
        val n = population.size
        val rows = levels.rowCount
        val total = levels.cellCount
        into.reserve(n, total)
        if (head.size < total) head = IntArray(total + total / 4)
        if (next.size < n) next = IntArray(n)
        if (locks.size < rows) {
            rowCount = IntArray(rows + rows / 4 + 1)
            // Last, since its length says how many there is room for: an allocation before it may have failed.
            locks = Array(rows + rows / 4) { Any() }
        }
        loop.run(total) { _, from, to -> head.fill(NONE, from, to) }
        rowCount.fill(0, 0, rows + 1)
        loop.run(n) { _, from, to ->
            findCells(population, levels, into, from, to)
            for (k in from until to) {
                val layout = levels[levels.of(population.radius[k])]
                hang(k, into.cellOf[k], layout.firstRow + (into.cellOf[k] - layout.firstCell) / layout.cells[0])
            }
        }
        for (row in 0 until rows) rowCount[row + 1] += rowCount[row]
        loop.run(rows, ROWS_A_PIECE) { _, from, to -> for (row in from until to) writeOut(row, levels, into) }
        into.start[total] = n
    }

    private fun hang(k: Int, cell: Int, row: Int) {
        synchronized(locks[row]) {
            next[k] = head[cell]
            head[cell] = k
            rowCount[row + 1]++
        }
    }

    private fun writeOut(row: Int, levels: GridLevels, into: CellOrder) {
        var slot = rowCount[row]
        val layout = levels[levels.ofRow(row)]
        val first = layout.firstCell + (row - layout.firstRow) * layout.cells[0]
        for (cell in first until first + layout.cells[0]) {
            into.start[cell] = slot
            val begin = slot
            var k = head[cell]
            while (k != NONE) {
                // Insertion sort: lists are short and nearly in descending order.
                var place = slot++
                while (place > begin && into.order[place - 1] > k) {
                    into.order[place] = into.order[place - 1]
                    place--
                }
                into.order[place] = k
                k = next[k]
            }
        }
    }

    private companion object {
        const val NONE = -1
        const val ROWS_A_PIECE = 16
    }
}
