package daphnis.core.parallel

import java.util.concurrent.CountDownLatch
import java.util.concurrent.Executor

/**
 * A thread handler on somebody else's [executor], for who has threads already. Worker 0 is the caller, the others are tasks; the executor must have a
 * free thread for at least one of them at some time, and the caller must not be its only one. Does not close the executor.
 */
public class ExecutorHandler(private val executor: Executor, override val threads: Int) : ThreadHandler {
    init {
        ThreadHandler.requireThreads(threads)
    }

    override fun run(task: WorkerTask) {
        val failure = FirstFailure()
        val others = CountDownLatch(threads - 1)
        for (worker in 1 until threads) {
            executor.execute {
                failure.guard { task.work(worker) }
                others.countDown()
            }
        }
        failure.guard { task.work(0) }
        var interrupted = false
        while (others.count > 0) {
            try {
                others.await()
            } catch (e: InterruptedException) {
                interrupted = true
            }
        }
        if (interrupted) Thread.currentThread().interrupt()
        failure.rethrow()
    }

    override fun close(): Unit = Unit
}
