package daphnis.core.parallel

import java.util.concurrent.CountDownLatch
import java.util.concurrent.Executor
import java.util.concurrent.atomic.AtomicIntegerArray

/**
 * A thread handler on somebody else's [executor], for who has threads already. Worker 0 is the caller, the others are
 * tasks. What no thread of the executor has begun when the caller has done its own part, the caller does too: so
 * nothing is waited for but what is being done, and an executor that is busy, rejects tasks, drops them or was shut
 * down costs time and nothing else. Does not close the executor.
 */
public class ExecutorHandler(private val executor: Executor, override val threads: Int) : ThreadHandler {
    init {
        ThreadHandler.requireThreads(threads)
    }

    override fun run(task: WorkerTask) {
        val parts = Parts(task, threads)
        for (worker in 1 until threads) {
            try {
                executor.execute { parts.work(worker) }
            } catch (e: Throwable) {
                // Rejected, or no thread to be had. An executor may throw what it likes; the part is done below.
            }
        }
        for (worker in 0 until threads) parts.work(worker)
        parts.await()
    }

    override fun close(): Unit = Unit

    /** The parts of one run. Each is done by who takes it first; a task that comes too late finds nothing to do. */
    private class Parts(private val task: WorkerTask, threads: Int) {
        private val taken = AtomicIntegerArray(threads)
        private val left = CountDownLatch(threads)
        private val failure = FirstFailure()

        fun work(worker: Int) {
            if (!taken.compareAndSet(worker, 0, 1)) return
            failure.guard { task.work(worker) }
            left.countDown()
        }

        fun await() {
            var interrupted = false
            while (left.count > 0) {
                try {
                    left.await()
                } catch (e: InterruptedException) {
                    interrupted = true
                }
            }
            if (interrupted) Thread.currentThread().interrupt()
            failure.rethrow()
        }
    }
}
