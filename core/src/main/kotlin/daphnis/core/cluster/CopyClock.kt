package daphnis.core.cluster

/**
 * When the leader fetches a copy of the state for safety: so often that the loss of a node costs seconds, and so seldom
 * that copies cost a small part of the time.
 *
 * @param now nanoseconds
 */
internal class CopyClock(private val now: () -> Long = System::nanoTime) {
    private var last = now()
    private var cost = 0L

    /** Whether a copy is due. */
    fun isDue(): Boolean = now() - last >= maxOf(LEAST, cost * SELDOM)

    /** Does [copy] and learns what it costs. */
    inline fun measure(copy: () -> Unit) {
        val began = now()
        copy()
        last = now()
        cost = last - began
    }

    private companion object {
        const val LEAST = 5_000_000_000L
        const val SELDOM = 20
    }
}
