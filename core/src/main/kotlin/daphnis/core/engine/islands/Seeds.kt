package daphnis.core.engine.islands

import daphnis.core.queue.EventStore
import java.util.concurrent.atomic.AtomicInteger

/**
 * The collisions of a window that are certain to happen unless another comes before. Islands grow from them. Each
 * worker fills its own part of the list; then every seed is hung into the list of its island by its link.
 */
internal class Seeds {
    /** All seeds. One that no worker has [reserved][reserve] must not be used. */
    val store = EventStore()
    private val size = AtomicInteger()

    /** Empties the list and makes room for [capacity] seeds. */
    fun reset(capacity: Int) {
        size.set(0)
        store.prepare(capacity)
    }

    /** @return the first of [count] entries that belong to the caller alone */
    fun reserve(count: Int): Int = size.getAndAdd(count)
}
