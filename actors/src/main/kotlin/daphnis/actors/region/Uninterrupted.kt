package daphnis.actors.region

import java.util.concurrent.ExecutionException
import java.util.concurrent.FutureTask

/** Does [work], again whenever an interrupt broke it off, and leaves the interrupt set. */
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

/** What [work] gives on a thread of its own, which no interrupt of this one reaches. */
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
