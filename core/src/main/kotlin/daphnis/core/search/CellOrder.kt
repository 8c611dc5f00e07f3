package daphnis.core.search

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
            cellOf = IntArray(spheres)
            // Last, since its length says how many there is room for: an allocation before it may have failed.
            order = IntArray(spheres)
        }
        // One entry more than needed at either end, see CellCounting.
        if (start.size < cells + 2) start = IntArray(cells + cells / 4 + 2)
    }
}
