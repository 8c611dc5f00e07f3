package daphnis.core.queue

import daphnis.core.queue.EventStore.Companion.NONE

/**
 * The fast [EventQueue]. All events of a step lie in [0, duration], so a calendar needs no overflow list: the step is
 * cut into buckets of equal width, with about two events each. A bucket is an unsorted linked list until its time
 * comes. Then it is drained into a small heap, which holds the exact order.
 *
 * ```
 *   time 0 ─────────────────────────────────────────▶ duration
 *   bucket │ 0 │ 1 │ 2 │ 3 │ 4 │ …           earlier buckets: empty
 *                    ▲ current: in the heap    later ones: linked lists, newest first
 * ```
 *
 * Removal is lazy, see [EventHeap]. When the store is full, dead events are squeezed out before it grows. Adding and
 * popping cost O(1) on average. Nothing is allocated once the store has its size.
 */
public class BucketEventQueue : EventQueue {
    /** The events of the current bucket; its store holds those of all buckets. */
    private val heap = EventHeap(INITIAL)
    private val store = heap.store

    override val time: Double get() = heap.time
    override val first: Int get() = heap.first
    override val second: Int get() = heap.second
    override val image: Int get() = heap.image

    /** Number of events of this step that have been squeezed out of the store. */
    private var squeezed = 0

    /** Number of events of the busiest of the last steps; fades by an eighth per step. */
    private var busiest = 0

    private var heads = IntArray(1)
    private var buckets = 1
    private var start = 0.0
    private var bucketsPerTime = 0.0
    private var current = 0

    override fun reset(duration: Double, ids: IntArray, count: Int) {
        reset(0.0, duration, ids, count)
    }

    /** The same for events from [start] to [end] only. */
    internal fun reset(start: Double, end: Double, ids: IntArray, count: Int) {
        this.start = start
        val duration = end - start
        busiest = maxOf(squeezed + store.size, busiest - busiest / 8)
        squeezed = 0
        heap.reset(duration, ids, count)
        // As many buckets as half the events of a step like the last one.
        buckets = (busiest / 2).coerceIn(1, MOST_BUCKETS)
        if (heads.size < buckets) heads = IntArray(buckets + buckets / 4)
        heads.fill(NONE, 0, buckets)
        bucketsPerTime = buckets / duration
        current = -1
    }

    /** Makes [slot] known after the [reset], see [EventHeap.include]. */
    internal fun include(slot: Int, ids: IntArray) {
        heap.include(slot, ids)
    }

    override fun add(time: Double, first: Int, second: Int, image: Int) {
        if (store.size == store.room) squeezeOrGrow()
        store.add(time, first, second, image)
        file(store.size - 1, time)
    }

    override fun pop(): Boolean {
        while (!heap.pop()) if (!fillHeap()) return false
        return true
    }

    override fun removeAllOf(slot: Int) {
        heap.removeAllOf(slot)
    }

    private fun bucketOf(time: Double): Int {
        val b = ((time - start) * bucketsPerTime).toInt()
        return if (b >= buckets) buckets - 1 else b
    }

    private fun file(e: Int, time: Double) {
        val b = bucketOf(time)
        if (b <= current) {
            heap.push(e, time)
        } else {
            store.link(e, heads[b])
            heads[b] = e
        }
    }

    /** Drains the next bucket that holds any event into the heap, which is empty; false when there is none. */
    private fun fillHeap(): Boolean {
        for (b in current + 1 until buckets) {
            var e = heads[b]
            if (e == NONE) continue
            current = b
            while (e != NONE) {
                if (!heap.isDead(e)) heap.push(e, store.time(e))
                e = store.link(e)
            }
            return true
        }
        current = buckets - 1
        return false
    }

    private fun squeezeOrGrow() {
        val before = store.size
        heap.squeeze()
        squeezed += before - store.size
        if (store.size > store.room / 4) store.grow()
        // Numbers have changed: everything is filed anew.
        heads.fill(NONE, 0, buckets)
        for (e in 0 until store.size) file(e, store.time(e))
    }

    private companion object {
        const val INITIAL = 1024
        const val MOST_BUCKETS = 1 shl 20
    }
}
