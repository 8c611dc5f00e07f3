package daphnis.core.engine.lists

/** Which spheres are in each cell, in rows of one length that spheres enter and leave. */
internal class ListCells {
    /** Row [cell] · [stride]: the number of spheres, and then the spheres. */
    var spheres = IntArray(0)
        private set
    private var stride = LEAST_STRIDE

    /** Whether there was no room for a sphere. */
    private var isFull = false

    /** Begins with [cells] empty ones. */
    fun begin(cells: Int) {
        isFull = false
        if (spheres.size < cells * stride) spheres = IntArray(cells * stride)
        for (c in 0 until cells) spheres[c * stride] = 0
    }

    /** Makes rows larger if one was too small. @return whether there is more room now */
    fun widen(): Boolean {
        val grows = isFull && stride < MOST_STRIDE
        if (grows) stride *= 2
        isFull = false
        return grows
    }

    fun first(cell: Int): Int = cell * stride + 1

    fun count(cell: Int): Int = spheres[cell * stride]

    /** @return false when there is no room */
    fun add(cell: Int, sphere: Int): Boolean {
        val count = spheres[cell * stride] + 1
        if (count == stride) {
            isFull = true
            return false
        }
        spheres[cell * stride] = count
        spheres[cell * stride + count] = sphere
        return true
    }

    fun remove(cell: Int, sphere: Int) {
        var k = first(cell)
        while (spheres[k] != sphere) k++
        val last = cell * stride + spheres[cell * stride]--
        spheres[k] = spheres[last]
    }

    private companion object {
        const val LEAST_STRIDE = 16
        const val MOST_STRIDE = 256
    }
}
