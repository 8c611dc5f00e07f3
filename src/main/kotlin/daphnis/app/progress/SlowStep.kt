package daphnis.app.progress

import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Says of a step that does not end how long it has run, once after [patience] and then each time that it has run twice
 * as long: nothing else of a run speaks within a step. [begin] and [end] come from the thread that drives the run.
 *
 * @param patience nanoseconds
 * @param able nanoseconds for which it has been possible to compute; 0 while it waits for nodes
 * @param say from a thread of this, with the number of the step and the seconds that it has run
 */
internal class SlowStep(
    private val patience: Long,
    private val able: () -> Long,
    private val say: (step: Long, seconds: Double) -> Unit,
) {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private var step = 0L
    private var began = 0L
    private var next = patience
    private var thread: Thread? = null

    /** Step [step] begins now; the one before has ended. */
    fun begin(step: Long): Unit = lock.withLock {
        this.step = step
        began = System.nanoTime()
        next = patience
        if (thread == null) {
            thread = Thread({ watch() }, "daphnis-slow-step").apply {
                isDaemon = true
                start()
            }
        }
    }

    /** No step is under way any more; nothing is said after this has returned. */
    fun end(): Unit = lock.withLock {
        thread = null
        changed.signalAll()
    }

    private fun watch(): Unit = lock.withLock {
        while (thread == Thread.currentThread()) {
            val run = minOf(System.nanoTime() - began, able())
            if (run >= next) {
                next = 2 * run
                say(step, run * SECONDS)
            }
            changed.awaitNanos(next - run)
        }
    }

    private companion object {
        const val SECONDS = 1e-9
    }
}
