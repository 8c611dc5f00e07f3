package daphnis.core.population

/**
 * How many boxes each sphere of a population has gone through along each axis, by [IdPlaces]. The counts are allocated
 * when the first sphere crosses a face. Within a step the first crossing keeps the counts of before. So a step without
 * a crossing costs nothing, and taking a step back is an exchange of references.
 */
internal class Crossings(val places: IdPlaces) {
    @Volatile
    private var counts: Array<IntArray>? = null

    /** The [counts] before the step, once the step has changed them; else a table to be reused, or none. */
    private var kept: Array<IntArray>? = null
    private var isTransaction = false

    /** Whether a sphere has crossed in the step under way. */
    @Volatile
    private var isChanged = false

    /** Whether any sphere has ever crossed. */
    private val isEmpty: Boolean get() = counts == null

    /** Adds the counts of the spheres with these [ids] to [other]. */
    fun copyInto(other: Crossings, ids: IntArray) {
        if (isEmpty) return
        for (axis in 0 until AXES) {
            for (id in ids) {
                val boxes = of(id, axis)
                if (boxes != 0) other.add(id, axis, boxes)
            }
        }
    }

    fun of(id: Int, axis: Int): Int = counts?.get(axis)?.getOrElse(places.of(id)) { 0 } ?: 0

    /** Threads may call this at the same time for different spheres. */
    fun add(id: Int, axis: Int, boxes: Int) {
        if (!isChanged && (isTransaction || isEmpty)) prepare()
        counts!![axis][places.of(id)] += boxes
    }

    /** Takes the memory that [add] may need, outside a step. */
    fun reserve() {
        if (isEmpty) prepare()
    }

    /** Hands every count that is not 0 to [take], and makes it 0. */
    fun drain(take: (id: Int, axis: Int, boxes: Int) -> Unit) {
        val counts = counts ?: return
        for (axis in 0 until AXES) {
            for (place in 0 until places.count) {
                val boxes = counts[axis][place]
                if (boxes != 0) take(places.idAt(place), axis, boxes)
                counts[axis][place] = 0
            }
        }
    }

    /** No thread writes counts before this is done, and none after [begin] without it. */
    @Synchronized
    private fun prepare() {
        if (isChanged) return
        val now = counts
        if (now == null) {
            kept = null
            counts = table()
        } else if (isTransaction) {
            val copy = kept ?: table()
            for (axis in 0 until AXES) now[axis].copyInto(copy[axis])
            kept = now
            counts = copy
        }
        isChanged = isTransaction
    }

    private fun table() = Array(AXES) { IntArray(places.count) }

    /** From now on [takeBack] is possible. */
    fun begin() {
        isTransaction = true
        isChanged = false
    }

    fun commit() {
        isTransaction = false
        isChanged = false
    }

    /** Restores the counts of [begin]. Allocates nothing. */
    fun takeBack() {
        if (isChanged) {
            val failed = counts
            counts = kept
            kept = failed
        }
        commit()
    }

    private companion object {
        const val AXES = 3
    }
}
