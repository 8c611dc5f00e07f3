package daphnis.core.parallel

import java.util.concurrent.atomic.AtomicReference

/** Keeps the first exception or error of any worker; later ones are suppressed in it. */
internal class FirstFailure {
    private val first = AtomicReference<Throwable?>()

    inline fun guard(work: () -> Unit) {
        try {
            work()
        } catch (e: Throwable) {
            add(e)
        }
    }

    fun add(e: Throwable) {
        val earlier = first.compareAndExchange(null, e)
        if (earlier == null || earlier === e) return
        try {
            earlier.addSuppressed(e)
        } catch (noMemory: OutOfMemoryError) {
            // The first is kept. A worker that threw here would not be counted as done.
        }
    }

    /** Throws what was kept, if anything, and forgets it. */
    fun rethrow() {
        first.getAndSet(null)?.let { throw it }
    }
}
