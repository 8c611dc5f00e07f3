package daphnis.core.parallel

/** The first form of the paper's handler: a new thread for every task. Its cost, some 50 µs a thread, is what [FixedPool] saves. */
public class ThreadPerTask(override val threads: Int) : ThreadHandler {
    @Volatile
    private var closed = false

    init {
        ThreadHandler.requireThreads(threads)
    }

    override fun run(task: WorkerTask) {
        check(!closed) { "the thread handler is closed" }
        val failure = FirstFailure()
        val others = Array(threads - 1) { k ->
            Thread({ failure.guard { task.work(k + 1) } }, "daphnis-task-${k + 1}").apply {
                isDaemon = true
                start()
            }
        }
        failure.guard { task.work(0) }
        var interrupted = false
        for (thread in others) {
            while (thread.isAlive) {
                try {
                    thread.join()
                } catch (e: InterruptedException) {
                    interrupted = true
                }
            }
        }
        if (interrupted) Thread.currentThread().interrupt()
        failure.rethrow()
    }

    override fun close() {
        closed = true
    }
}
