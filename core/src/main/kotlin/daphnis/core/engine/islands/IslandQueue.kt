package daphnis.core.engine.islands

import daphnis.core.collision.StepRows
import daphnis.core.queue.compareTied

/**
 * The queue of one island: a binary heap in the order of events, for a handful of them. Removal is lazy, as in
 * [daphnis.core.queue.BucketEventQueue]: an event is dead when its number lies below that of the first event that came
 * after the last change of either sphere. Spheres are addressed by their place in the worker's rows.
 */
internal class IslandQueue(private val rows: StepRows) {
    var time = 0.0
        private set
    var first = -1
        private set
    var second = -1
        private set
    var image = 0
        private set

    private var validFrom = IntArray(INITIAL)
    private var times = DoubleArray(INITIAL)
    private var data = IntArray(INITIAL * WIDTH)
    private var heap = IntArray(INITIAL)
    private var count = 0
    private var heapSize = 0
    private var most = 0L

    /** Forgets all events; there may be so many as [limits] say, until they are forgotten. */
    fun clear(limits: IslandLimits) {
        count = 0
        heapSize = 0
        most = limits.events
    }

    /** Makes sphere [k] known. */
    fun join(k: Int) {
        if (k >= validFrom.size) validFrom = validFrom.copyOf(k * 2)
        validFrom[k] = 0
    }

    fun add(time: Double, first: Int, second: Int, image: Int) {
        if (count == times.size) grow()
        val e = count++
        times[e] = time
        val p = e * WIDTH
        data[p] = first
        data[p + 1] = second
        data[p + 2] = image
        push(e)
    }

    fun pop(): Boolean {
        while (heapSize > 0) {
            val e = takeLeast()
            val p = e * WIDTH
            val a = data[p]
            val b = data[p + 1]
            if (e < validFrom[a] || (b >= 0 && e < validFrom[b])) continue
            time = times[e]
            first = a
            second = b
            image = data[p + 2]
            return true
        }
        return false
    }

    fun removeAllOf(k: Int) {
        validFrom[k] = count
    }

    private fun grow() {
        if (count >= most) throw IslandsTooLargeException("potential collisions of one island", most)
        times = times.copyOf(count * 2)
        data = data.copyOf(count * 2 * WIDTH)
        heap = heap.copyOf(count * 2)
    }

    private fun isEarlier(a: Int, b: Int): Boolean {
        val s = times[a]
        val t = times[b]
        if (s != t) return s < t
        val p = a * WIDTH
        val q = b * WIDTH
        return compareTied(rows.id, data[p], data[p + 1], data[p + 2], data[q], data[q + 1], data[q + 2]) < 0
    }

    private fun push(e: Int) {
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
        const val INITIAL = 64
        const val WIDTH = 3
    }
}
