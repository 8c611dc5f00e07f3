package daphnis.core.parallel

/**
 * The first form of the paper's handler: a new thread for every task. [FixedPool] saves its cost, some 50 µs per
 * thread. If the system gives no more threads, the caller does the work of the missing ones after its own.
 *
 * @param start starts a thread; for tests in which it fails
 */
public class ThreadPerTask internal constructor(override val threads: Int, private val start: (Thread) -> Unit) :
    ThreadHandler {
    public constructor(threads: Int) : this(threads, Thread::start)

    @Volatile
    private var closed = false

    init {
        ThreadHandler.requireThreads(threads)
    }

    override fun run(task: WorkerTask) {
        check(!closed) { "the thread handler is closed" }
        val failure = FirstFailure()
        val others = ArrayList<Thread>(threads - 1)
        try {
            for (worker in 1 until threads) {
                val thread = Thread({ failure.guard { task.work(worker) } }, "daphnis-task-$worker")
                thread.isDaemon = true
                start(thread)
                others += thread
            }
        } catch (e: OutOfMemoryError) {
            // Out of memory or of threads.
        }
        failure.guard { task.work(0) }
        for (worker in others.size + 1 until threads) failure.guard { task.work(worker) }
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
