package daphnis.core.population

/**
 * A place for each id of the spheres that a population began with, in the order of ids: the id itself where ids are
 * dense, else its rank. So a table by place takes memory by the number of spheres, whatever the largest id is. Fixed
 * for the life of the population: a place outlives its sphere.
 *
 * @param sorted the ids, ascending
 */
internal class IdPlaces(sorted: IntArray) {
    private val ranked: IntArray? = sorted.takeIf { IdSlots.areSparse(it) }

    /** Number of places; some are empty when ids have gaps. */
    val count: Int = if (ranked != null) sorted.size else (sorted.lastOrNull() ?: -1) + 1

    /** The place of [id]; any number outside of `0 until count` when no sphere had it. */
    fun of(id: Int): Int = ranked?.binarySearch(id) ?: id
}
