package daphnis.core.queue

import daphnis.core.growth.GrowingTable

/**
 * Potential collisions by number, from 0 in the order in which they were added. Each has a time, its two spheres, an
 * image and one link to another event, with which its owner makes lists.
 *
 * Three longs per event, so that one event is one or two cache lines: time as bits | first, second | image, link.
 * Nothing is allocated once the store has its size. Single-threaded.
 *
 * @param capacity events for which there is room at first, at least 1
 */
internal class EventStore(capacity: Int = INITIAL) :
    GrowingTable(),
    EventSink {
    private var data = LongArray(0)

    init {
        reserve(capacity)
    }

    override fun resize(room: Int) {
        data = data.copyOf(room * WIDTH)
    }

    /** Appends an event, linked to none. */
    override fun add(time: Double, first: Int, second: Int, image: Int) {
        val p = append() * WIDTH
        data[p] = time.toRawBits()
        data[p + 1] = pack(first, second)
        data[p + 2] = pack(image, NONE)
    }

    fun time(e: Int): Double = Double.fromBits(data[e * WIDTH])

    /** One slot of event [e], [NONE] once it was [taken][take]. */
    fun first(e: Int): Int = high(data[e * WIDTH + 1])

    /** The other slot, or the negative partner number of a wall. */
    fun second(e: Int): Int = low(data[e * WIDTH + 1])

    /** Image code of the second as seen from the first. */
    fun image(e: Int): Int = high(data[e * WIDTH + 2])

    /** The event to which [e] is linked, [NONE] when there is none. */
    fun link(e: Int): Int = low(data[e * WIDTH + 2])

    /** Links event [e] to event [next], or to [NONE]. */
    fun link(e: Int, next: Int) {
        data[e * WIDTH + 2] = pack(image(e), next)
    }

    /** Marks event [e] as one that has been handed out: its first sphere is [NONE]. */
    fun take(e: Int) {
        data[e * WIDTH + 1] = pack(NONE, NONE)
    }

    /** Copies event [from] over event [to]. */
    fun copy(from: Int, to: Int) {
        data.copyInto(data, to * WIDTH, from * WIDTH, (from + 1) * WIDTH)
    }

    /** Forgets all events but the first [count]. */
    fun truncate(count: Int) {
        size = count
    }

    /** Doubles the room; the events stay. */
    fun grow() {
        reserve(room * 2)
    }

    /** The order of events [a] and [b], which are at one time, like a comparator; the slots have these [ids]. */
    fun compareTied(a: Int, b: Int, ids: IntArray): Int =
        compareTied(ids, first(a), second(a), image(a), first(b), second(b), image(b))

    private fun pack(high: Int, low: Int): Long = (high.toLong() shl 32) or (low.toLong() and 0xffffffffL)

    private fun high(packed: Long): Int = (packed shr 32).toInt()

    private fun low(packed: Long): Int = packed.toInt()

    companion object {
        /** No event, no sphere. */
        const val NONE = -1
        private const val INITIAL = 64
        private const val WIDTH = 3
    }
}
