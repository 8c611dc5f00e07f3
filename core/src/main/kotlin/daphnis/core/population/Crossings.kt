package daphnis.core.population

/**
 * How many boxes each sphere of a population has gone through along each axis, by [IdPlaces]. The counts are allocated
 * when the first sphere crosses a face. The crossings of a step are kept in a list, by which the step can be taken
 * back. So a sphere that does not cross costs nothing.
 */
internal class Crossings(val places: IdPlaces) {
    @Volatile
    private var counts: Array<IntArray>? = null
    private var isTransaction = false

    /** The crossings of the step under way: place, axis and boxes of each, [listed] numbers in all. */
    private var list = IntArray(0)
    private var listed = 0

    /** Whether no sphere has crossed yet. */
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
        if (isTransaction) return addToStep(places.of(id), axis, boxes)
        if (isEmpty) prepare()
        counts!![axis][places.of(id)] += boxes
    }

    /** Memory that is missing is taken before anything changes. */
    @Synchronized
    private fun addToStep(place: Int, axis: Int, boxes: Int) {
        prepare()
        if (list.size < listed + ENTRY) list = list.copyOf(maxOf(FIRST * ENTRY, 2 * listed))
        counts!![axis][place] += boxes
        list[listed] = place
        list[listed + 1] = axis
        list[listed + 2] = boxes
        listed += ENTRY
    }

    /** Takes the memory that [add] may need, outside a step. */
    fun reserve(): Unit = prepare()

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

    /** No thread writes counts before they are there. */
    @Synchronized
    private fun prepare() {
        if (isEmpty) counts = Array(AXES) { IntArray(places.count) }
    }

    /** From now on [takeBack] is possible. */
    fun begin() {
        isTransaction = true
        listed = 0
    }

    fun commit() {
        isTransaction = false
        listed = 0
    }

    /** Restores the counts of [begin]. Allocates nothing. */
    fun takeBack() {
        for (k in 0 until listed step ENTRY) counts!![list[k + 1]][list[k]] -= list[k + 2]
        commit()
    }

    private companion object {
        const val AXES = 3

        /** Numbers of an entry of the list, and entries for which there is room at first. */
        const val ENTRY = 3
        const val FIRST = 64
    }
}
