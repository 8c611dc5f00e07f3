package daphnis.core.queue

/**
 * The fast [EventQueue]. All events of a step lie in [0, duration], so a calendar needs no overflow list: the step is
 * cut into buckets of equal width, about two events each; a bucket is an unsorted linked list until its time comes,
 * then it is drained into a small binary heap that holds the exact order.
 *
 * ```
 *   time 0 ─────────────────────────────────────────▶ duration
 *   bucket │ 0 │ 1 │ 2 │ 3 │ 4 │ …           earlier buckets: empty
 *                    ▲ current: in the heap    later ones: linked lists, newest first
 * ```
 *
 * Removal is lazy. Events are numbered in the order of their insertion; `validFrom[slot]` is the number of the first
 * event that came after the last [removeAllOf] of this slot, so an event is dead when its number is below that of
 * either of its spheres. When the store is full, the dead are squeezed out before it grows. Adding and popping cost
 * O(1) on average; nothing is allocated once the store has its size.
 */
public class BucketEventQueue : EventQueue {
    override var time: Double = 0.0
        private set
    override var first: Int = -1
        private set
    override var second: Int = -1
        private set
    override var image: Int = 0
        private set

    private var ids = IntArray(0)
    private var slots = 0
    private var validFrom = IntArray(0)

    // The store, three longs an event in order of insertion, so that one event is one or two cache lines:
    // time as bits | first, second | image, next event of the bucket.
    private var store = LongArray(INITIAL * WIDTH)
    private var capacity = INITIAL
    private var count = 0
    private var added = 0
    private var busiest = 0

    private var heads = IntArray(1)
    private var buckets = 1
    private var bucketsPerTime = 0.0
    private var current = 0

    private var heap = IntArray(INITIAL)
    private var heapSize = 0

    override fun reset(duration: Double, ids: IntArray, count: Int) {
        this.ids = ids
        slots = count
        if (validFrom.size < count) validFrom = IntArray(count) else validFrom.fill(0, 0, count)
        // As many buckets as half the events of a step like the last one.
        busiest = maxOf(added + this.count, busiest - busiest / 8)
        buckets = (busiest / 2).coerceIn(1, MOST_BUCKETS)
        if (heads.size < buckets) heads = IntArray(buckets + buckets / 4)
        heads.fill(NONE, 0, buckets)
        bucketsPerTime = buckets / duration
        this.count = 0
        added = 0
        current = -1
        heapSize = 0
    }

    override fun add(time: Double, first: Int, second: Int, image: Int) {
        if (count == capacity) squeezeOrGrow()
        val e = count++
        val p = e * WIDTH
        store[p] = time.toRawBits()
        store[p + 1] = pack(first, second)
        store[p + 2] = pack(image, NONE)
        file(e)
    }

    override fun pop(): Boolean {
        while (true) {
            if (heapSize == 0 && !fillHeap()) return false
            val e = takeLeast()
            val p = e * WIDTH
            val pair = store[p + 1]
            if (isDead(e, pair)) continue
            time = Double.fromBits(store[p])
            first = high(pair)
            second = low(pair)
            image = high(store[p + 2])
            // A popped event must not come back when the store is squeezed.
            store[p + 1] = pack(NONE, NONE)
            return true
        }
    }

    override fun removeAllOf(slot: Int) {
        validFrom[slot] = count
    }

    private fun isDead(e: Int, pair: Long): Boolean {
        val a = high(pair)
        val b = low(pair)
        return a < 0 || e < validFrom[a] || (b >= 0 && e < validFrom[b])
    }

    private fun bucketOf(time: Double): Int {
        val b = (time * bucketsPerTime).toInt()
        return if (b >= buckets) buckets - 1 else b
    }

    private fun file(e: Int) {
        val p = e * WIDTH
        val b = bucketOf(Double.fromBits(store[p]))
        if (b <= current) {
            push(e)
        } else {
            store[p + 2] = pack(high(store[p + 2]), heads[b])
            heads[b] = e
        }
    }

    private fun fillHeap(): Boolean {
        var b = current
        while (heapSize == 0) {
            b++
            if (b >= buckets) {
                current = buckets - 1
                return false
            }
            var e = heads[b]
            while (e != NONE) {
                if (!isDead(e, store[e * WIDTH + 1])) push(e)
                e = low(store[e * WIDTH + 2])
            }
        }
        current = b
        return true
    }

    private fun squeezeOrGrow() {
        var kept = 0
        for (e in 0 until count) {
            if (isDead(e, store[e * WIDTH + 1])) continue
            store.copyInto(store, kept * WIDTH, e * WIDTH, (e + 1) * WIDTH)
            kept++
        }
        if (kept > capacity / 4) {
            capacity *= 2
            store = store.copyOf(capacity * WIDTH)
            heap = heap.copyOf(capacity)
        }
        // Numbers have changed: all that is left is alive, and everything is filed anew.
        validFrom.fill(0, 0, slots)
        added += count - kept
        count = kept
        heapSize = 0
        heads.fill(NONE, 0, buckets)
        for (e in 0 until kept) file(e)
    }

    private fun isEarlier(a: Int, b: Int): Boolean {
        val s = Double.fromBits(store[a * WIDTH])
        val t = Double.fromBits(store[b * WIDTH])
        if (s != t) return s < t
        val p = store[a * WIDTH + 1]
        val q = store[b * WIDTH + 1]
        return compareTied(
            ids,
            high(p),
            low(p),
            high(store[a * WIDTH + 2]),
            high(q),
            low(q),
            high(store[b * WIDTH + 2]),
        ) <
            0
    }

    private fun pack(high: Int, low: Int): Long = (high.toLong() shl 32) or (low.toLong() and 0xffffffffL)

    private fun high(packed: Long): Int = (packed shr 32).toInt()

    private fun low(packed: Long): Int = packed.toInt()

    private fun push(e: Int) {
        val heap = heap
        var k = heapSize++
        while (k > 0) {
            val parent = (k - 1) shr 1
            if (!isEarlier(e, heap[parent])) break
            heap[k] = heap[parent]
            k = parent
        }
        heap[k] = e
    }

    private fun takeLeast(): Int {
        val heap = heap
        val least = heap[0]
        val n = --heapSize
        if (n > 0) {
            val e = heap[n]
            var k = 0
            while (true) {
                var child = 2 * k + 1
                if (child >= n) break
                if (child + 1 < n && isEarlier(heap[child + 1], heap[child])) child++
                if (!isEarlier(heap[child], e)) break
                heap[k] = heap[child]
                k = child
            }
            heap[k] = e
        }
        return least
    }

    private companion object {
        const val NONE = -1
        const val INITIAL = 1024
        const val WIDTH = 3
        const val MOST_BUCKETS = 1 shl 20
    }
}
