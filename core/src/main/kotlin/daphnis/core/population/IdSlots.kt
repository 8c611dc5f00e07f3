package daphnis.core.population

/**
 * A place for each sphere of a population that depends on the ids alone, in their order: the id itself where ids are
 * dense, else its rank among them. So columns by place take memory by the number of spheres, whatever the largest id
 * is. Reused; allocates nothing once warm while ids are dense.
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
        isDense = bound <= DENSE * size.toLong() + FEW
        count = if (isDense) bound.toInt() else size
        if (isDense) return
        if (sorted.size != size) sorted = IntArray(size)
        id.copyInto(sorted)
        sorted.sort()
    }

    /** The place of the sphere with [id], which must be one of the population. */
    fun of(id: Int): Int = if (isDense) id else sorted.binarySearch(id)

    /** The first place of the ids from [leastId] on. */
    fun from(leastId: Int): Int {
        if (isDense) return minOf(count, leastId)
        val place = sorted.binarySearch(leastId)
        return if (place < 0) -place - 1 else place
    }

    private companion object {
        /** Places a sphere at most, and how many more may be empty. */
        const val DENSE = 2
        const val FEW = 64
    }
}
