package daphnis.core.engine.threadpool

import java.util.concurrent.atomic.AtomicBoolean

/**
 * Mutual exclusion for some hundred nanoseconds at a time. A thread that waits spins, and after a while yields to other
 * threads, but never sleeps. Not reentrant.
 */
internal class SpinLock {
    private val held = AtomicBoolean()

    fun lock() {
        var spins = 0
        while (held.get() || !held.compareAndSet(false, true)) relax(spins++)
    }

    fun unlock() {
        held.set(false)
    }

    inline fun <T> use(work: () -> T): T {
        lock()
        try {
            return work()
        } finally {
            unlock()
        }
    }

    companion object {
        private const val SPINS = 200

        /** One turn of waiting, the [spins]-th. */
        fun relax(spins: Int) {
            if (spins < SPINS) Thread.onSpinWait() else Thread.yield()
        }
    }
}
