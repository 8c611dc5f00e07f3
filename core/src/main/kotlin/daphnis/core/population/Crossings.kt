package daphnis.core.population

/**
 * How many boxes each sphere of a population has gone through along each axis, by [IdPlaces]. The counts are allocated
 * when the first sphere crosses a face. The crossings of a step are kept in a list, by which the step can be taken
 * back. So a sphere that does not cross costs nothing.
 *
 * @param areFew whether it is a small part of all spheres that crosses before the next [drain]
 */
internal class Crossings(val places: IdPlaces, private val areFew: Boolean = false) {
    @Volatile
    private var counts: Counts? = null
    private var isTransaction = false

    /** The crossings of the step under way: place, axis and boxes of each, [listed] numbers in all. */
    private var list = IntArray(0)
    private var listed = 0

    /** Whether no sphere has crossed yet. */
    private val isEmpty: Boolean get() = counts == null

    /** Adds the counts of the spheres with these [ids] to [other]. */
    fun copyInto(other: Crossings, ids: Iterable<Int>) {
        if (isEmpty) return
        for (axis in 0 until AXES) {
            for (id in ids) {
                val boxes = of(id, axis)
                if (boxes != 0) other.add(id, axis, boxes)
            }
        }
    }

    /** With places for [ids], the counts of the spheres [there] among them. */
    fun only(ids: IntArray, there: Iterable<Int>): Crossings =
        Crossings(IdPlaces(ids.copyOf().apply { sort() })).also { copyInto(it, there) }

    /** The same counts, with places for the new [ids] too, which are ascending, and 0 for them and all above. */
    fun alsoFor(ids: IntArray): Crossings = Crossings(places.with(ids), areFew).also { all ->
        copyInto(all, (0 until places.count).map(places::idAt).filter { it < ids[0] })
    }

    /** Whether there is a place for [id]. */
    fun has(id: Int): Boolean = places.of(id) in 0 until places.count

    fun of(id: Int, axis: Int): Int = counts?.get(places.of(id), axis) ?: 0

    /** Threads may call this at the same time for different spheres. */
    fun add(id: Int, axis: Int, boxes: Int) {
        if (isTransaction) return addToStep(places.of(id), axis, boxes)
        if (isEmpty) prepare()
        counts!!.add(places.of(id), axis, boxes)
    }

    /** Memory that is missing is taken before anything changes. */
    @Synchronized
    private fun addToStep(place: Int, axis: Int, boxes: Int) {
        prepare()
        if (list.size < listed + ENTRY) list = list.copyOf(maxOf(FIRST * ENTRY, 2 * listed))
        counts!!.add(place, axis, boxes)
        list[listed] = place
        list[listed + 1] = axis
        list[listed + 2] = boxes
        listed += ENTRY
    }

    /** Takes the memory that [add] may need, outside a step. */
    fun reserve(): Unit = prepare()

    /** Hands every count that is not 0 to [take], and makes it 0. */
    fun drain(take: (id: Int, axis: Int, boxes: Int) -> Unit) {
        counts?.drain { place, axis, boxes -> take(places.idAt(place), axis, boxes) }
    }

    /** No thread writes counts before they are there. */
    @Synchronized
    private fun prepare() {
        if (isEmpty) counts = if (areFew) FewCounts() else AllCounts(places.count)
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
        for (k in 0 until listed step ENTRY) counts!!.add(list[k], list[k + 1], -list[k + 2])
        commit()
    }

    private companion object {
        /** Numbers of an entry of the list, and entries for which there is room at first. */
        const val ENTRY = 3
        const val FIRST = 64
    }
}

/** Numbers by place and axis, at first 0. */
private interface Counts {
    fun get(place: Int, axis: Int): Int

    /** Takes no memory where the number was changed before. */
    fun add(place: Int, axis: Int, boxes: Int)

    /** Hands every number that is not 0 to [take], by axis and then by place, and makes it 0. */
    fun drain(take: (place: Int, axis: Int, boxes: Int) -> Unit)
}

private class AllCounts(places: Int) : Counts {
    private val counts = Array(AXES) { IntArray(places) }

    override fun get(place: Int, axis: Int): Int = counts[axis].getOrElse(place) { 0 }

    override fun add(place: Int, axis: Int, boxes: Int) {
        counts[axis][place] += boxes
    }

    override fun drain(take: (place: Int, axis: Int, boxes: Int) -> Unit) {
        for (axis in 0 until AXES) {
            val along = counts[axis]
            for (place in along.indices) {
                if (along[place] != 0) take(place, axis, along[place])
                along[place] = 0
            }
        }
    }
}

/** Those that were changed, in a table with open addresses. */
private class FewCounts : Counts {
    private var keys = LongArray(FIRST) { FREE }
    private var values = IntArray(FIRST)
    private var size = 0

    private fun key(place: Int, axis: Int) = axis.toLong() shl Int.SIZE_BITS or place.toLong()

    private fun slot(key: Long, keys: LongArray): Int {
        var slot = (key * FACTOR ushr Int.SIZE_BITS).toInt() and keys.size - 1
        while (keys[slot] != FREE && keys[slot] != key) slot = slot + 1 and keys.size - 1
        return slot
    }

    override fun get(place: Int, axis: Int): Int = if (place < 0) 0 else values[slot(key(place, axis), keys)]

    override fun add(place: Int, axis: Int, boxes: Int) {
        val key = key(place, axis)
        var slot = slot(key, keys)
        if (keys[slot] == FREE) {
            if (2 * (size + 1) > keys.size) {
                grow()
                slot = slot(key, keys)
            }
            keys[slot] = key
            size++
        }
        values[slot] += boxes
    }

    private fun grow() {
        val more = LongArray(2 * keys.size) { FREE }
        val moreValues = IntArray(more.size)
        for (old in keys.indices) {
            if (keys[old] == FREE) continue
            val slot = slot(keys[old], more)
            more[slot] = keys[old]
            moreValues[slot] = values[old]
        }
        keys = more
        values = moreValues
    }

    override fun drain(take: (place: Int, axis: Int, boxes: Int) -> Unit) {
        val changed = keys.indices.filter { keys[it] != FREE && values[it] != 0 }.sortedBy { keys[it] }
        for (slot in changed) take(keys[slot].toInt(), (keys[slot] shr Int.SIZE_BITS).toInt(), values[slot])
        keys.fill(FREE)
        values.fill(0)
        size = 0
    }

    private companion object {
        const val FREE = -1L
        const val FIRST = 256
        const val FACTOR = -0x61c8864680b583ebL
    }
}

private const val AXES = 3
