package daphnis.core.queue

import daphnis.core.growth.GrowingTable

/**
 * The [EventQueue] for a few events at a time: a binary heap of the numbers of the events in its [store].
 *
 * Removal is lazy. `validFrom[slot]` is the number of the first event that came after the last [removeAllOf] of this
 * slot, so an event is dead when its number is below that of either of its spheres. Dead events stay in the store until
 * [reset] or [squeeze]. Nothing is allocated once the arrays have their size.
 *
 * @param capacity events for which there is room at first, at least 1
 */
internal class EventHeap(capacity: Int = INITIAL) :
    GrowingTable(),
    EventQueue {
    /** All events added since the last [reset] or [squeeze], including dead ones. */
    val store = EventStore(capacity)

    override var time = 0.0
        private set
    override var first = -1
        private set
    override var second = -1
        private set
    override var image = 0
        private set

    private var ids = IntArray(0)
    private var validFrom = IntArray(capacity)

    // The heap, side by side since most comparisons need no more than the time: number of the event, and its time.
    private var heap = IntArray(0)
    private var times = DoubleArray(0)

    override fun resize(room: Int) {
        heap = heap.copyOf(room)
        times = times.copyOf(room)
    }

    override fun reset(duration: Double, ids: IntArray, count: Int) {
        this.ids = ids
        if (validFrom.size < count) validFrom = IntArray(count) else validFrom.fill(0, 0, count)
        store.clear()
        clear()
    }

    /**
     * Makes [slot] known after the [reset]. Its id is `ids[slot]`; the ids of the slots known before must stay the
     * same.
     */
    fun include(slot: Int, ids: IntArray) {
        this.ids = ids
        if (slot >= validFrom.size) validFrom = validFrom.copyOf(maxOf(slot + 1, validFrom.size * 2))
        validFrom[slot] = 0
    }

    override fun add(time: Double, first: Int, second: Int, image: Int) {
        store.add(time, first, second, image)
        push(store.size - 1, time)
    }

    override fun pop(): Boolean {
        while (size > 0) {
            val t = times[0]
            val e = takeLeast()
            val a = store.first(e)
            val b = store.second(e)
            if (isDead(e, a, b)) continue
            time = t
            first = a
            second = b
            image = store.image(e)
            // It must not come back when the store is squeezed.
            store.take(e)
            return true
        }
        return false
    }

    override fun removeAllOf(slot: Int) {
        validFrom[slot] = store.size
    }

    /** Whether event [e] was removed or handed out. */
    fun isDead(e: Int): Boolean = isDead(e, store.first(e), store.second(e))

    private fun isDead(e: Int, a: Int, b: Int): Boolean = a < 0 || e < validFrom[a] || (b >= 0 && e < validFrom[b])

    /** Removes dead events and gives the live ones new numbers, in the same order. The heap is empty then. */
    fun squeeze() {
        var kept = 0
        for (e in 0 until store.size) if (!isDead(e)) store.copy(e, kept++)
        store.truncate(kept)
        validFrom.fill(0)
        clear()
    }

    /** Puts event [e] of the store, which is at [time], into the heap. */
    fun push(e: Int, time: Double) {
        var k = append()
        val heap = heap
        val times = times
        while (k > 0) {
            val parent = (k - 1) shr 1
            if (!precedes(time, e, times[parent], heap[parent])) break
            heap[k] = heap[parent]
            times[k] = times[parent]
            k = parent
        }
        heap[k] = e
        times[k] = time
    }

    private fun takeLeast(): Int {
        val least = heap[0]
        val n = --size
        if (n > 0) sink(heap[n], times[n], n)
        return least
    }

    /** Puts event [e], which is at [time], at its place among the first [n] entries, of which the top is free. */
    private fun sink(e: Int, time: Double, n: Int) {
        val heap = heap
        val times = times
        var k = 0
        while (true) {
            var child = 2 * k + 1
            if (child >= n) break
            if (child + 1 < n && precedes(times[child + 1], heap[child + 1], times[child], heap[child])) child++
            if (!precedes(times[child], heap[child], time, e)) break
            heap[k] = heap[child]
            times[k] = times[child]
            k = child
        }
        heap[k] = e
        times[k] = time
    }

    /** Whether event [a] at time [s] comes before event [b] at time [t]. */
    private fun precedes(s: Double, a: Int, t: Double, b: Int): Boolean =
        s < t || s == t && store.compareTied(a, b, ids) < 0

    private companion object {
        const val INITIAL = 64
    }
}
