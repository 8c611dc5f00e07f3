package daphnis.core.parallel

/**
 * Runs one piece of work on all of its threads at once: the thread handler of Lewis & Massingill. The caller's thread
 * is worker 0.
 *
 * Every worker sees what the caller wrote before [run]. The caller sees what the workers wrote once [run] has returned.
 */
public interface ThreadHandler : AutoCloseable {
    /** Number of workers, the caller included; ≥ 1. */
    public val threads: Int

    /**
     * Calls `task.work(worker)` once for each worker in `0 until threads`, at the same time, and returns when all have
     * returned. One caller at a time. An interrupt of the caller does not end the wait; its flag is set again
     * afterwards.
     *
     * @throws Throwable the first failure of a worker, after all have ended; the others are suppressed in it
     * @throws IllegalStateException after [close]
     */
    public fun run(task: WorkerTask)

    /** Ends the threads. A run under way is finished first. Closing twice is allowed. */
    override fun close()

    public companion object {
        /** Most threads an engine takes. */
        public const val MOST: Int = 256

        internal fun requireThreads(threads: Int) {
            require(threads in 1..MOST) { "threads is $threads; it must be in 1..$MOST" }
        }
    }
}

/** What each worker does. */
public fun interface WorkerTask {
    public fun work(worker: Int)
}
