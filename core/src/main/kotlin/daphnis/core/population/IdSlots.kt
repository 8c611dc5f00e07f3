package daphnis.core.population

/**
 * A place for each sphere of a population that depends on the ids alone, in their order: the id itself where ids are
 * dense, else its rank among them. So columns by place take memory by the number of spheres, whatever the largest id
 * is. Reused; allocates nothing once warm while ids are dense. By the spheres there are now, so that a sum over places
 * does not remember those that were removed; [IdPlaces] are for what does.
 */
internal class IdSlots {
    /** Number of places; some are empty when ids have gaps. */
    var count = 0
        private set

    private var sorted = IntArray(0)
    private var isDense = true

    fun prepare(population: Population) {
        val id = population.id
        val size = population.size
        var bound = 0L
        for (k in 0 until size) bound = maxOf(bound, id[k] + 1L)
        isDense = areDense(bound, size)
        count = if (isDense) bound.toInt() else size
        if (isDense) return
        if (sorted.size != size) sorted = IntArray(size)
        id.copyInto(sorted)
        sorted.sort()
    }

    /** The place of the sphere with [id], which must be one of the population. */
    fun of(id: Int): Int = if (isDense) id else sorted.binarySearch(id)

    /** The first place of the ids from [leastId] on; [count] for [Int.MAX_VALUE], which stands for none. */
    fun from(leastId: Int): Int {
        if (leastId == Int.MAX_VALUE) return count
        if (isDense) return minOf(count, leastId)
        val place = sorted.binarySearch(leastId)
        return if (place < 0) -place - 1 else place
    }

    companion object {
        /** Places a sphere at most, and how many more may be empty. */
        private const val DENSE = 2
        private const val FEW = 64

        /** Whether the ids [sorted], ascending, leave so many gaps that a table by id would waste memory. */
        fun areSparse(sorted: IntArray): Boolean = sorted.isNotEmpty() && !areDense(sorted.last() + 1L, sorted.size)

        private fun areDense(bound: Long, size: Int): Boolean = bound <= DENSE * size.toLong() + FEW
    }
}
