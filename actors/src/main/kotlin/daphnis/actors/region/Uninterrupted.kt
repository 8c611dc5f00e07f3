package daphnis.actors.region

import java.util.concurrent.ExecutionException
import java.util.concurrent.FutureTask

/** Runs [work], and runs it again whenever an interrupt ended it; leaves the interrupt set. */
internal inline fun uninterrupted(work: () -> Unit) {
    var isInterrupted = Thread.interrupted()
    try {
        while (true) {
            try {
                work()
                return
            } catch (e: InterruptedException) {
                isInterrupted = true
            }
        }
    } finally {
        if (isInterrupted) Thread.currentThread().interrupt()
    }
}

/** The result of [work] on its own thread, which no interrupt of this thread reaches. */
internal fun <T : Any> onFreshThread(work: () -> T): T {
    val task = FutureTask(work)
    Thread(task, "daphnis-start").apply { isDaemon = true }.start()
    var result: T? = null
    try {
        uninterrupted { result = task.get() }
    } catch (e: ExecutionException) {
        throw e.cause ?: e
    }
    return result!!
}
