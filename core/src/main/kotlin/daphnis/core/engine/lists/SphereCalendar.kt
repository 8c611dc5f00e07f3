package daphnis.core.engine.lists

import kotlin.math.max

/**
 * When each sphere has its next event, and which sphere is next in the present step. A step is cut into buckets of
 * equal width with a few spheres each; a bucket is a linked list until its time comes, then a small heap holds the
 * exact order. A sphere is in one place only, so nothing has to be thrown away later.
 *
 * ```
 *   time 0 ─────────────────────────────────▶ duration
 *   bucket │ 0 │ 1 │ 2 │ 3 │ 4 │ …              a sphere whose event comes after the step is in none
 *                    ▲ current: in the heap
 * ```
 */
internal class SphereCalendar(private val ties: Ties) {
    /** Says which of two events at one time comes first. */
    fun interface Ties {
        fun isBefore(a: Int, b: Int): Boolean
    }

    /** When the next event of each sphere is, from the start of the step. */
    var time = DoubleArray(0)
        private set

    /** Two numbers per sphere: the next and the previous sphere in its bucket. */
    private var links = IntArray(0)

    /** The bucket of a sphere, [NONE], or [IN_HEAP] minus its place in the heap. */
    private var place = IntArray(0)
    private var heads = IntArray(0)
    private var buckets = 1
    private var current = NONE
    private var bucketsPerTime = 0.0
    private var duration = 0.0
    private var heap = IntArray(0)
    private var heapSize = 0

    /** Events taken in this step. */
    var taken = 0
        private set

    /** Makes room for [spheres], of which none has an event. */
    fun reserve(spheres: Int) {
        if (place.size < spheres) {
            heap = IntArray(spheres)
            links = IntArray(2 * spheres)
            time = DoubleArray(spheres)
            // Last, since its length says how many spheres there is room for.
            place = IntArray(spheres)
        }
        clear(spheres)
    }

    /** No sphere is in a bucket any more; times stay. */
    private fun clear(spheres: Int) {
        place.fill(NONE, 0, spheres)
        heapSize = 0
    }

    /** Begins a step of [duration] for [spheres], in which about so many [events] are expected. */
    fun begin(spheres: Int, duration: Double, events: Int) {
        clear(spheres)
        this.duration = duration
        buckets = events.coerceIn(LEAST_BUCKETS, MOST_BUCKETS)
        if (heads.size < buckets) heads = IntArray(buckets + buckets / 4)
        heads.fill(NONE, 0, buckets)
        bucketsPerTime = buckets / duration
        current = NONE
        taken = 0
    }

    /** The next event of [sphere] is at [at], in this step or later. */
    fun put(sphere: Int, at: Double) {
        remove(sphere)
        time[sphere] = at
        if (at > duration) return
        val b = (at * bucketsPerTime).toInt().let { if (it >= buckets) buckets - 1 else it }
        if (b <= current) push(sphere) else link(sphere, b)
    }

    /** The next event of [sphere] is not in this step, and not before [at], which may be its end. */
    fun putLater(sphere: Int, at: Double) {
        remove(sphere)
        time[sphere] = max(at, duration)
    }

    /** The sphere with the next event; it stays there until it is [put] elsewhere. [NONE] at the end of the step. */
    fun next(): Int {
        while (heapSize == 0) {
            if (current == buckets - 1) return NONE
            var sphere = heads[++current]
            while (sphere != NONE) {
                val following = links[2 * sphere]
                push(sphere)
                sphere = following
            }
        }
        taken++
        return heap[0]
    }

    /** Whether another event is at [at], when all earlier ones have been taken. */
    fun hasMoreAt(at: Double): Boolean = heapSize > 0 && time[heap[0]] == at

    private fun link(sphere: Int, b: Int) {
        val head = heads[b]
        links[2 * sphere] = head
        links[2 * sphere + 1] = NONE
        if (head != NONE) links[2 * head + 1] = sphere
        heads[b] = sphere
        place[sphere] = b
    }

    private fun remove(sphere: Int) {
        val b = place[sphere]
        if (b == NONE) return
        place[sphere] = NONE
        if (b <= IN_HEAP) return removeFromHeap(IN_HEAP - b)
        val next = links[2 * sphere]
        val previous = links[2 * sphere + 1]
        if (previous == NONE) heads[b] = next else links[2 * previous] = next
        if (next != NONE) links[2 * next + 1] = previous
    }

    private fun push(sphere: Int) {
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
        place[sphere] = IN_HEAP - k
    }

    private fun isBefore(a: Int, b: Int): Boolean {
        val s = time[a]
        val t = time[b]
        return s < t || s == t && ties.isBefore(a, b)
    }

    companion object {
        const val NONE = -1
        private const val IN_HEAP = -2
        private const val LEAST_BUCKETS = 16
        private const val MOST_BUCKETS = 1 shl 18
    }
}
