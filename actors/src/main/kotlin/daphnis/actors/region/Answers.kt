package daphnis.actors.region

import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicIntegerArray
import java.util.concurrent.atomic.AtomicReferenceArray
import java.util.concurrent.locks.LockSupport

/**
 * The coordinator's mailbox: room for one answer from each region, since a region gets its next share only after it has
 * answered the last one. Putting an answer in allocates nothing, never waits and throws nothing, so a region can report
 * even that it ran out of memory.
 *
 * Hand-over: share worked on → answer put in its place (volatile) → taken by the coordinator.
 */
internal class Answers(count: Int) {
    /** [DONE], or what the region threw; null when there is no answer. */
    private val answers = AtomicReferenceArray<Any?>(count)
    private val gone = AtomicIntegerArray(count)
    private val counted = AtomicInteger()

    /** The thread that waits for answers. Written before the first share of a step is sent. */
    @Volatile
    var reader: Thread? = null

    /** How many answers have come since the start, plus the regions that have left. */
    val count: Int get() = counted.get()

    /** Called by [region]: it has done its share, or has thrown [failure]. */
    fun put(region: Int, failure: Throwable?) {
        answers.set(region, failure ?: DONE)
        tell()
    }

    /** Called by the code that runs [region]: it takes no more shares. */
    fun leave(region: Int) {
        gone.set(region, 1)
        tell()
    }

    /** Whether [region] takes no more shares. An answer may still be here. */
    fun hasLeft(region: Int): Boolean = gone.get(region) != 0

    /** Whether an answer of [region] is here. */
    fun has(region: Int): Boolean = answers.get(region) != null

    /** Takes the answer of [region], if there is one, and gives [follow] what the region threw, null for nothing. */
    inline fun take(region: Int, follow: (Throwable?) -> Unit) {
        val answer = answers.getAndSet(region, null) ?: return
        follow(answer as? Throwable)
    }

    private fun tell() {
        counted.incrementAndGet()
        try {
            LockSupport.unpark(reader)
        } catch (e: Throwable) {
            // Out of memory, for example. The waiting thread looks again after a slice of time.
        }
    }

    private companion object {
        val DONE = Any()
    }
}
