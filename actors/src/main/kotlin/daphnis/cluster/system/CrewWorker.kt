package daphnis.cluster.system

import daphnis.cluster.link.CrewMail
import daphnis.core.cluster.MailClosedException
import daphnis.core.cluster.NodeWork
import java.util.concurrent.Executors
import java.util.concurrent.RejectedExecutionException

/**
 * The thread of a node's work: one crew after the other, and of those that ended before their turn none.
 *
 * @param failed is told in words what [work] has thrown, unless that is the end of the mail
 */
internal class CrewWorker(
    private val work: NodeWork,
    private val threads: Int,
    private val failed: (CrewMail, String) -> Unit,
) {
    private val executor = Executors.newSingleThreadExecutor { task ->
        Thread(task, "daphnis-node").apply { isDaemon = true }
    }

    fun begin(mail: CrewMail) {
        try {
            executor.execute { run(mail) }
        } catch (_: RejectedExecutionException) {
            // The node is closed, and so is its mail.
        }
    }

    /** Lets the thread end after its work. */
    fun end(): Unit = executor.shutdown()

    private fun run(mail: CrewMail) {
        if (mail.isClosed) return
        try {
            work.work(mail, threads)
        } catch (e: MailClosedException) {
            if (!mail.isClosed) failed(mail, words(e))
        } catch (e: Throwable) {
            failed(mail, words(e))
        }
    }

    /** What a user is to read: the message alone says enough only of exceptions that were made for that. */
    private fun words(e: Throwable) = e.javaClass.simpleName + e.message?.let { ": $it" }.orEmpty()
}
