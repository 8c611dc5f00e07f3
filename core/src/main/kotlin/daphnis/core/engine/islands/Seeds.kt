package daphnis.core.engine.islands

import java.util.concurrent.atomic.AtomicInteger

/**
 * The collisions of a window that are certain to happen unless another comes before: what islands grow from. Each
 * worker fills a stretch of its own; then every seed is hung into the list of its island, whose root is a slot.
 */
internal class Seeds {
    var time = DoubleArray(0)
        private set
    var first = IntArray(0)
        private set
    var second = IntArray(0)
        private set
    var image = IntArray(0)
        private set

    /** Next seed of the same island, −1 at the end. */
    var next = IntArray(0)
        private set

    private val size = AtomicInteger()

    /** Empties the list and makes room for [capacity] seeds. */
    fun reset(capacity: Int) {
        size.set(0)
        if (time.size >= capacity) return
        val n = capacity + capacity / 2
        time = DoubleArray(n)
        first = IntArray(n)
        second = IntArray(n)
        image = IntArray(n)
        next = IntArray(n)
    }

    /** @return the first of [count] entries that are the caller's alone */
    fun reserve(count: Int): Int = size.getAndAdd(count)
}
