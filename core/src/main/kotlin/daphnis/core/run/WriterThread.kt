package daphnis.core.run

/**
 * Writes on a thread of its own, so that the steps go on meanwhile. Beside the piece being written at most one state
 * waits, and rows of [mostRows] bytes or one piece; beyond that, the run waits.
 *
 * Hand-over: the run fills a piece → [jobs], under the monitor → the thread takes it from there and is the only one to
 * touch it. The thread becomes idle or fails, under the monitor → [await] and [check] see it, and all that it wrote.
 *
 * Where memory is short a state is waited for, and the run takes no more of it than without the thread. An interrupt of
 * the thread that waits does not end the wait, and is still set after it.
 *
 * @param memory free memory in bytes
 * @param start starts a thread; where there is none to be had, everything is written at once
 */
internal class WriterThread(
    private val mostRows: Long = minOf(MOST_ROWS, Runtime.getRuntime().maxMemory() / ROWS_SHARE),
    private val memory: () -> Long = ::freeMemory,
    start: (Thread) -> Unit = Thread::start,
) : Writer {
    /** @param rows bytes of rows, or −1 for a state */
    private class Job(val rows: Long, val write: () -> Unit)

    /** Not a `ReentrantLock`, which allocates to wait. */
    @Suppress("PLATFORM_CLASS_MAPPED_TO_KOTLIN")
    private val monitor = Object()

    // The rest only under the monitor.
    private val jobs = ArrayDeque<Job>()
    private var waitingRows = 0L
    private var stateWaits = false
    private var isWriting = false
    private var isClosed = false

    /** Whether there is no thread, or it has ended. */
    private var isOver = false
    private var isThrown = false

    /** The first one; written under the monitor. */
    @Volatile
    private var failure: Throwable? = null

    init {
        try {
            start(Thread(::serve, "daphnis-writer").apply { isDaemon = true })
        } catch (e: OutOfMemoryError) {
            // Out of memory or of threads.
            isOver = true
        }
    }

    override fun rows(bytes: Long, write: () -> Unit) {
        waitWhile { waitingRows > 0 && waitingRows + bytes > mostRows }
        handOver(Job(bytes, write))
    }

    override fun <S> state(bytes: Long, copy: () -> S, write: (S) -> Unit) {
        waitWhile { stateWaits }
        if (failure != null) return
        val state = try {
            copy()
        } catch (e: OutOfMemoryError) {
            // What is being written may be what takes the memory.
            waitWhile { isBusy() }
            copy()
        }
        handOver(Job(STATE) { write(state) })
        if (memory() < bytes * STATES) waitWhile { isBusy() }
    }

    override fun check() {
        if (failure == null) return
        synchronized(monitor) {
            if (isThrown) return
            isThrown = true
        }
        failure?.let { throw it }
    }

    override fun await() {
        waitWhile { isBusy() }
        check()
    }

    override fun close() {
        synchronized(monitor) {
            isClosed = true
            monitor.notifyAll()
        }
        await()
    }

    private fun isBusy() = isWriting || jobs.isNotEmpty()

    private fun handOver(job: Job) {
        synchronized(monitor) {
            check(!isClosed) { "the writer is closed" }
            if (!isOver) {
                jobs.addLast(job)
                if (job.rows == STATE) stateWaits = true else waitingRows += job.rows
                monitor.notifyAll()
                return
            }
        }
        write(job)
    }

    /** Waits until [condition] is false, which it is once all is written. */
    private inline fun waitWhile(condition: () -> Boolean) {
        var interrupted = false
        synchronized(monitor) {
            while (!isOver && condition()) {
                try {
                    monitor.wait()
                } catch (e: InterruptedException) {
                    interrupted = true
                }
            }
        }
        if (interrupted) Thread.currentThread().interrupt()
    }

    private fun serve() {
        try {
            while (true) write(next() ?: return)
        } finally {
            synchronized(monitor) {
                isOver = true
                monitor.notifyAll()
            }
        }
    }

    /** The next piece; null when there is none and there will be none. */
    private fun next(): Job? = synchronized(monitor) {
        isWriting = false
        monitor.notifyAll()
        while (jobs.isEmpty()) {
            if (isClosed) return null
            try {
                monitor.wait()
            } catch (e: InterruptedException) {
                // An interrupt of this thread has no meaning.
            }
        }
        isWriting = true
        val job = jobs.removeFirst()
        if (job.rows == STATE) stateWaits = false else waitingRows -= job.rows
        monitor.notifyAll()
        job
    }

    private fun write(job: Job) {
        if (failure != null) return
        try {
            job.write()
        } catch (e: Throwable) {
            synchronized(monitor) { failure = e }
        }
    }

    internal companion object {
        private const val STATE = -1L
        private const val MOST_ROWS = 1L shl 24
        private const val ROWS_SHARE = 16

        /** A state is written from a copy and takes about three times as much while it is put into a file. */
        private const val STATES = 4

        private fun freeMemory(): Long = Runtime.getRuntime().let {
            it.maxMemory() - it.totalMemory() + it.freeMemory()
        }
    }
}
