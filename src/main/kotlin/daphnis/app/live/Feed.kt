package daphnis.app.live

import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * What a live page shows: the latest text of each kind, numbered as they come. Any thread may [put], [end] and read;
 * all fields are guarded by [lock].
 *
 * @param longestArrival from one file of a page to the next, or to when it looks
 */
internal class Feed(private val longestArrival: Duration = 2.seconds) {
    /** A text of a [kind], the [number]th of all. */
    class Entry(val kind: String, val text: String, val number: Long)

    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val latest = LinkedHashMap<String, Entry>()
    private var count = 0L
    private val watchers = ArrayList<Watcher>()
    private var isEnded = false

    /** Until when a page that has been sent is waited for, by the clock of nanoseconds; null without one. */
    private var arrival: Long? = null

    /** Whether somebody looks, or will as soon as its page is there. */
    val isWatched: Boolean get() = lock.withLock { watchers.isNotEmpty() || isAwaited() }

    /** Whether somebody looks, or will, that wants entries of [kind]. */
    fun wants(kind: String): Boolean = lock.withLock { isAwaited() || watchers.any { it.without != kind } }

    /** How many look that want entries of [kind]. */
    fun watching(kind: String): Int = lock.withLock { watchers.count { it.without != kind } }

    /** A page, or a part of one, has been sent, which will look when it has all. */
    fun expect(): Unit = lock.withLock { arrival = System.nanoTime() + longestArrival.inWholeNanoseconds }

    /** Waits until no page is on its way. */
    fun awaitArrival(): Unit = lock.withLock { while (isAwaited()) changed.awaitNanos(nanosecondsToArrival()) }

    private fun isAwaited() = nanosecondsToArrival() > 0

    private fun nanosecondsToArrival() = arrival?.let { it - System.nanoTime() } ?: 0

    fun put(kind: String, text: String): Unit = lock.withLock {
        if (isEnded) return
        latest[kind] = Entry(kind, text, ++count)
        changed.signalAll()
    }

    /** The last entry: nothing is taken after it. */
    fun end(text: String): Unit = lock.withLock {
        put(END, text)
        isEnded = true
    }

    /**
     * One more looks, for all kinds but [without]; null when [most] do already. To be closed when it does no longer.
     */
    fun watch(most: Int, without: String? = null): Watcher? = lock.withLock {
        arrival = null
        changed.signalAll()
        if (watchers.size >= most) null else Watcher(without).also { watchers += it }
    }

    /** Waits until nobody looks, at most [milliseconds]. */
    fun awaitNobody(milliseconds: Long): Unit = lock.withLock {
        var left = TimeUnit.MILLISECONDS.toNanos(milliseconds)
        while (watchers.isNotEmpty() && left > 0) left = changed.awaitNanos(left)
    }

    /** Somebody who looks, on a thread of its own. */
    inner class Watcher(val without: String?) : AutoCloseable {
        private var seen = 0L

        /** What is new, waiting for it up to [milliseconds]; the latest of a kind only, in the order they came. */
        fun next(milliseconds: Long): List<Entry> = lock.withLock {
            if (count == seen) changed.await(milliseconds, TimeUnit.MILLISECONDS)
            latest.values.filter { it.number > seen && it.kind != without }.sortedBy { it.number }.also { seen = count }
        }

        override fun close(): Unit = lock.withLock {
            watchers -= this
            changed.signalAll()
        }
    }

    companion object {
        const val RUN = "run"
        const val PROGRESS = "progress"

        /** From above, as an image. */
        const val PICTURE = "picture"

        /** That there is a newer state. */
        const val STATE = "state"

        /** Which states there are. */
        const val STATES = "states"
        const val SERIES = "series"
        const val PROBLEM = "problem"
        const val END = "end"
    }
}
