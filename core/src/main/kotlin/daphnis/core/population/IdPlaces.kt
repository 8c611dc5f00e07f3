package daphnis.core.population

/**
 * A place for each id of the spheres with which a population began or which were added since, in the order of ids. It
 * is the id itself where ids are dense, otherwise its rank. So the memory of a table by place depends on the number of
 * spheres, not on the largest id. A place stays after its sphere is removed, until spheres are added.
 *
 * @param sorted the ids, ascending
 */
internal class IdPlaces(sorted: IntArray) {
    private val ranked: IntArray? = sorted.takeIf { isSparse(it) }

    /** Number of places; some are empty when ids have gaps. */
    val count: Int = if (ranked != null) sorted.size else (sorted.lastOrNull() ?: -1) + 1

    /** The place of [id]; any number outside `0 until count` when no sphere had it. */
    fun of(id: Int): Int = ranked?.binarySearch(id) ?: id

    private companion object {
        /** The most places per sphere, and how many more may be empty. */
        const val DENSE = 2
        const val FEW = 64

        /** Whether the ids [sorted] leave so many gaps that a table by id would waste memory. */
        fun isSparse(sorted: IntArray): Boolean =
            sorted.isNotEmpty() && sorted.last() + 1L > DENSE * sorted.size.toLong() + FEW
    }
}
