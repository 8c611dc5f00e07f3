package daphnis.core.population

/**
 * A place for each id of the spheres that a population began with or took on since, in the order of ids: the id itself
 * where ids are dense, else its rank. So a table by place takes memory by the number of spheres, whatever the largest
 * id is. A place outlives its sphere until others are added.
 *
 * @param sorted the ids, ascending
 */
internal class IdPlaces(sorted: IntArray) {
    private val ranked: IntArray? = sorted.takeIf { isSparse(it) }

    /** Number of places; some are empty when ids have gaps. */
    val count: Int = if (ranked != null) sorted.size else (sorted.lastOrNull() ?: -1) + 1

    /** The place of [id]; any number outside of `0 until count` when no sphere had it. */
    fun of(id: Int): Int = ranked?.binarySearch(id) ?: id

    private companion object {
        /** Places a sphere at most, and how many more may be empty. */
        const val DENSE = 2
        const val FEW = 64

        /** Whether the ids [sorted] leave so many gaps that a table by id would waste memory. */
        fun isSparse(sorted: IntArray): Boolean =
            sorted.isNotEmpty() && sorted.last() + 1L > DENSE * sorted.size.toLong() + FEW
    }
}
