package daphnis.core.population

/**
 * A place for each id of the spheres with which a population began or which were added since, in the order of ids. It
 * is the id itself where ids are dense, otherwise its rank. So the memory of a table by place depends on the number of
 * spheres, not on the largest id. A place stays after its sphere is removed, until spheres are added.
 */
internal class IdPlaces private constructor(
    /** All ids, where they are not dense. */
    val ranked: IntArray?,
    /** Number of places; some are empty when ids have gaps. */
    val count: Int,
) {
    /** @param sorted the ids, ascending */
    constructor(sorted: IntArray) : this(
        sorted.takeIf { isSparse(it) },
        if (isSparse(sorted)) sorted.size else (sorted.lastOrNull() ?: -1) + 1,
    )

    /** The id at [place]. */
    fun idAt(place: Int): Int = ranked?.get(place) ?: place

    /** The place of [id]; any number outside `0 until count` when no sphere had it. */
    fun of(id: Int): Int = ranked?.binarySearch(id) ?: id

    /** These places, and such for [ids], which are ascending. */
    fun with(ids: IntArray): IdPlaces {
        if (ranked == null) return IdPlaces(null, maxOf(count, ids.last() + 1))
        val all = (ranked.asList() + ids.asList()).distinct().toIntArray().apply { sort() }
        return IdPlaces(all, all.size)
    }

    companion object {
        /** The most places per sphere, and how many more may be empty. */
        private const val DENSE = 2
        private const val FEW = 64

        /** The places of other places' [ranked] and [count]. */
        fun like(ranked: IntArray?, count: Int): IdPlaces = IdPlaces(ranked, count)

        /** Whether the ids [sorted] leave so many gaps that a table by id would waste memory. */
        private fun isSparse(sorted: IntArray): Boolean =
            sorted.isNotEmpty() && sorted.last() + 1L > DENSE * sorted.size.toLong() + FEW
    }
}
