package daphnis.core.engine.lists

import kotlin.math.max

/**
 * Which sphere of some has the next event in the present step. A stretch of time is cut into buckets of equal width
 * with a few spheres each; a bucket is a linked list until its time comes, then a small heap holds the exact order. A
 * sphere is in one place only, so nothing has to be thrown away later.
 *
 * ```
 *   time start ─────────────────────────────▶ end
 *   bucket │ 0 │ 1 │ 2 │ 3 │ 4 │ …              a sphere whose event comes after the end is in none
 *                    ▲ current: in the heap
 * ```
 *
 * @param table times of the events, and where spheres are; a sphere is in one calendar at a time
 */
internal class SphereCalendar(private val table: EventTable, private val ties: Ties) {
    /** Says which of two events at one time comes first. */
    fun interface Ties {
        fun isBefore(a: Int, b: Int): Boolean
    }

    private var heads = IntArray(0)
    private var buckets = 1
    private var current = NONE
    private var bucketsPerTime = 0.0
    private var start = 0.0
    private var end = 0.0
    private var heap = IntArray(LEAST_BUCKETS)
    private var heapSize = 0

    /** Events taken since [begin]. */
    var taken = 0
        private set

    /**
     * Begins a stretch of time from [start] to [end], in which about so many [events] are expected. No sphere is in a
     * place of this calendar any more.
     */
    fun begin(start: Double, end: Double, events: Int) {
        heapSize = 0
        this.start = start
        this.end = end
        buckets = events.coerceIn(LEAST_BUCKETS, MOST_BUCKETS)
        if (heads.size < buckets) heads = IntArray(buckets + buckets / 4)
        heads.fill(NONE, 0, buckets)
        bucketsPerTime = buckets / (end - start)
        current = NONE
        taken = 0
    }

    private fun bucketOf(at: Double): Int = ((at - start) * bucketsPerTime).toInt().coerceIn(0, buckets - 1)

    /** The next event of [sphere] is at [at], in this stretch or later. */
    fun put(sphere: Int, at: Double) {
        remove(sphere)
        table.setTime(sphere, at)
        if (at > end) return
        val b = bucketOf(at)
        if (b <= current) push(sphere) else link(sphere, b)
    }

    /** The next event of [sphere] is not in this stretch, and not before [at], which may be its end. */
    fun putLater(sphere: Int, at: Double) {
        remove(sphere)
        table.setTime(sphere, max(at, end))
    }

    /**
     * The sphere with the next event, which is no later than [until]; it stays there until it is [put] elsewhere.
     * [NONE] when there is none.
     */
    fun next(until: Double): Int {
        while (heapSize == 0) {
            if (current == bucketOf(until)) return NONE
            var sphere = heads[++current]
            while (sphere != NONE) {
                val following = table.next(sphere)
                push(sphere)
                sphere = following
            }
        }
        if (table.time(heap[0]) > until) return NONE
        taken++
        return heap[0]
    }

    /** Whether another event is at [at], when all earlier ones have been taken. */
    fun hasMoreAt(at: Double): Boolean = heapSize > 0 && table.time(heap[0]) == at

    private fun link(sphere: Int, b: Int) {
        val head = heads[b]
        table.setNext(sphere, head)
        table.setPrevious(sphere, NONE)
        if (head != NONE) table.setPrevious(head, sphere)
        heads[b] = sphere
        table.setPlace(sphere, b)
    }

    /** The [sphere] is in no place of this calendar, whatever its time. */
    fun remove(sphere: Int) {
        val b = table.place(sphere)
        if (b == NONE) return
        table.setPlace(sphere, NONE)
        if (b <= IN_HEAP) return removeFromHeap(IN_HEAP - b)
        val next = table.next(sphere)
        val previous = table.previous(sphere)
        if (previous == NONE) heads[b] = next else table.setNext(previous, next)
        if (next != NONE) table.setPrevious(next, previous)
    }

    private fun push(sphere: Int) {
        if (heapSize == heap.size) heap = heap.copyOf(2 * heapSize)
        rise(sphere, heapSize++)
    }

    private fun removeFromHeap(k: Int) {
        val last = heap[--heapSize]
        if (k == heapSize) return
        if (k > 0 && isBefore(last, heap[(k - 1) shr 1])) rise(last, k) else sink(last, k)
    }

    private fun rise(sphere: Int, from: Int) {
        var k = from
        while (k > 0) {
            val parent = (k - 1) shr 1
            if (!isBefore(sphere, heap[parent])) break
            set(k, heap[parent])
            k = parent
        }
        set(k, sphere)
    }

    private fun sink(sphere: Int, from: Int) {
        var k = from
        while (true) {
            var child = 2 * k + 1
            if (child >= heapSize) break
            if (child + 1 < heapSize && isBefore(heap[child + 1], heap[child])) child++
            if (!isBefore(heap[child], sphere)) break
            set(k, heap[child])
            k = child
        }
        set(k, sphere)
    }

    private fun set(k: Int, sphere: Int) {
        heap[k] = sphere
        table.setPlace(sphere, IN_HEAP - k)
    }

    private fun isBefore(a: Int, b: Int): Boolean {
        val s = table.time(a)
        val t = table.time(b)
        return s < t || s == t && ties.isBefore(a, b)
    }

    companion object {
        const val NONE = -1
        private const val IN_HEAP = -2
        private const val LEAST_BUCKETS = 16
        private const val MOST_BUCKETS = 1 shl 18
    }
}
