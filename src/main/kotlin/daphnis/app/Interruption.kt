package daphnis.app

import daphnis.app.printing.flushPrinted
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/**
 * Turns Ctrl-C and a polite kill into a request that the run sees between two steps. The JVM ends as soon as its hooks
 * have, so the hook waits until the run has written its checkpoint, but not for ever: a step that does not end is given
 * up, and the last checkpoint stands.
 *
 * @param endWaits ends what a run may wait for within a step
 */
internal class Interruption(private val endWaits: () -> Unit = {}) {
    @Volatile
    var requested = false

    /** Whether there is a run that can end with a checkpoint. */
    @Volatile
    var armed = false

    private val finished = CountDownLatch(1)
    private val hook = Thread {
        requested = true
        endWaits()
        if (armed && finished.await(LONGEST_WAIT_SECONDS, TimeUnit.SECONDS)) Runtime.getRuntime().halt(EXIT_INTERRUPTED)
    }

    init {
        Runtime.getRuntime().addShutdownHook(hook)
    }

    fun done() {
        flushPrinted()
        finished.countDown()
        try {
            Runtime.getRuntime().removeShutdownHook(hook)
        } catch (e: IllegalStateException) {
            // The hook runs already: it will end the process; nothing may be returned to the shell before.
            Thread.currentThread().join()
        }
    }

    private companion object {
        const val LONGEST_WAIT_SECONDS = 60L
    }
}
