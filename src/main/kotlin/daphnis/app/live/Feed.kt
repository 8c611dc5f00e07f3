package daphnis.app.live

import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * What a live page shows: the latest text of each kind, numbered as they come. Any thread may [put], [end] and read;
 * all fields are guarded by [lock].
 */
internal class Feed {
    /** A text of a [kind], the [number]th of all. */
    class Entry(val kind: String, val text: String, val number: Long)

    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val latest = LinkedHashMap<String, Entry>()
    private var count = 0L
    private var watchers = 0
    private var isEnded = false

    val isWatched: Boolean get() = lock.withLock { watchers > 0 }

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

    /** One more looks; null when [most] do already. To be closed when it does no longer. */
    fun watch(most: Int): Watcher? = lock.withLock { if (watchers >= most) null else Watcher().also { watchers++ } }

    /** Waits until nobody looks, at most [milliseconds]. */
    fun awaitNobody(milliseconds: Long): Unit = lock.withLock {
        var left = TimeUnit.MILLISECONDS.toNanos(milliseconds)
        while (watchers > 0 && left > 0) left = changed.awaitNanos(left)
    }

    /** Somebody who looks, on a thread of its own. */
    inner class Watcher : AutoCloseable {
        private var seen = 0L

        /** What is new, waiting for it up to [milliseconds]; the latest of a kind only, in the order they came. */
        fun next(milliseconds: Long): List<Entry> = lock.withLock {
            if (count == seen) changed.await(milliseconds, TimeUnit.MILLISECONDS)
            latest.values.filter { it.number > seen }.sortedBy { it.number }.also { seen = count }
        }

        override fun close(): Unit = lock.withLock {
            watchers--
            changed.signalAll()
        }
    }

    companion object {
        const val END = "end"
    }
}
