package daphnis.core.parallel

import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.LockSupport

/**
 * The second form of the paper's handler: threads that are kept and wait for the next task. They spin for some
 * microseconds before they sleep, since the phases of a step follow one another closely.
 *
 * Hand-over: [run] writes [task] and [remaining], then [generation] (volatile) → a worker sees the new generation, then
 * reads the task and works → it decrements [remaining] (atomic) → the caller sees 0 and returns. A sleeper sets its
 * flag and looks at the generation once more before it parks, and [run] looks at the flags after it has written the
 * generation, so one of the two sees the other.
 *
 * If the system gives no more threads, the caller does the work of the missing ones after its own. An interrupt of a
 * worker has no meaning. It is cleared, because a thread with the flag set could not sleep.
 *
 * @param start starts a thread; for tests in which it fails
 */
public class FixedPool internal constructor(override val threads: Int, private val start: (Thread) -> Unit) :
    ThreadHandler {
    public constructor(threads: Int) : this(threads, Thread::start)

    private val workers = arrayOfNulls<Thread>(threads)
    private val asleep = Array(threads) { AtomicInteger() }
    private val remaining = AtomicInteger()
    private val failure = FirstFailure()
    private var task: WorkerTask = WorkerTask { }

    /** Workers that have a thread, the caller among them; 0 before the first run. */
    private var running = 0

    @Volatile
    private var generation = 0

    @Volatile
    private var closed = false

    @Volatile
    private var caller: Thread? = null

    init {
        ThreadHandler.requireThreads(threads)
    }

    override fun run(task: WorkerTask) {
        if (threads == 1) {
            check(!closed) { CLOSED }
            task.work(0)
            return
        }
        synchronized(this) {
            check(!closed) { CLOSED }
            check(caller == null) { "the thread handler is running a task already" }
            caller = Thread.currentThread()
            if (running == 0) startThreads()
            this.task = task
            remaining.set(running - 1)
            generation++
        }
        for (k in 1 until running) if (asleep[k].get() != 0) LockSupport.unpark(workers[k])
        failure.guard { task.work(0) }
        for (k in running until threads) failure.guard { task.work(k) }
        awaitOthers()
        caller = null
        failure.rethrow()
    }

    private fun awaitOthers() {
        var interrupted = false
        var spins = 0
        while (remaining.get() > 0) {
            if (spins < SPINS) {
                spins++
                Thread.onSpinWait()
            } else {
                asleep[0].set(1)
                if (remaining.get() > 0) LockSupport.park(this)
                asleep[0].set(0)
                if (Thread.interrupted()) interrupted = true
            }
        }
        if (interrupted) Thread.currentThread().interrupt()
    }

    private fun startThreads() {
        running = 1
        try {
            for (k in 1 until threads) {
                val thread = Thread({ serve(k) }, "daphnis-pool-$k").apply { isDaemon = true }
                start(thread)
                workers[k] = thread
                running++
            }
        } catch (e: OutOfMemoryError) {
            // Out of memory or of threads: the pool works with those it has.
        }
    }

    private fun serve(worker: Int) {
        var seen = 0
        while (awaitGeneration(worker, seen)) {
            seen++
            failure.guard { task.work(worker) }
            val boss = caller
            if (remaining.decrementAndGet() == 0 && asleep[0].get() != 0) LockSupport.unpark(boss)
        }
    }

    /** @return false when the pool is closed and nothing is left to do */
    private fun awaitGeneration(worker: Int, seen: Int): Boolean {
        var spins = 0
        while (generation == seen) {
            if (closed) {
                // A pool is closed after the last task was announced.
                if (generation == seen) return false
            } else if (spins < SPINS) {
                spins++
                Thread.onSpinWait()
            } else {
                asleep[worker].set(1)
                if (generation == seen && !closed) LockSupport.park(this)
                asleep[worker].set(0)
                Thread.interrupted()
            }
        }
        return true
    }

    override fun close() {
        synchronized(this) { closed = true }
        for (k in 1 until threads) workers[k]?.let { LockSupport.unpark(it) }
    }

    private companion object {
        const val CLOSED = "the thread handler is closed"

        /** Some tens of microseconds. */
        const val SPINS = 2000
    }
}
