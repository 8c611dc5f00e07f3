package daphnis.core.parallel

import java.util.concurrent.CountDownLatch
import java.util.concurrent.Executor
import java.util.concurrent.atomic.AtomicIntegerArray

/**
 * A thread handler on an [executor] of the host, for a program that has threads already. Worker 0 is the caller, the
 * others are tasks. When the caller has done its own part, it also does the parts that no thread of the executor has
 * begun. So it waits only for work in progress, and an executor that is busy, rejects tasks, drops them or was shut
 * down costs only time. Does not close the executor.
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
                // Rejected, or no thread available. An executor may throw anything; the part is done below.
            }
        }
        for (worker in 0 until threads) parts.work(worker)
        parts.await()
    }

    override fun close(): Unit = Unit

    /**
     * The parts of one run. The thread that takes a part first does it; a task that comes too late finds nothing to do.
     */
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
