package daphnis.actors.region

import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicIntegerArray
import java.util.concurrent.atomic.AtomicReferenceArray

/**
 * The coordinator's mailbox: room for one answer from each region, since a region gets its next command only after it
 * has answered the last one. Putting an answer in allocates nothing, never waits and throws nothing, so a region can
 * report even that it ran out of memory.
 *
 * Hand-over: reply filled → put in its place (volatile) → taken by the coordinator → read.
 */
internal class Answers(count: Int) {
    private val replies = AtomicReferenceArray<RegionReply?>(count)
    private val failures = AtomicReferenceArray<Throwable?>(count)
    private val gone = AtomicIntegerArray(count)
    private val counted = AtomicInteger()

    /** Wakes the thread or coroutine that waits for answers. Written before the first command of a step is sent. */
    @Volatile
    var waker: Waker = Waker { }

    /** How many answers have come since the start, plus the regions that have left. */
    val count: Int get() = counted.get()

    /** Called by a region: [reply] to its command. */
    fun put(reply: RegionReply) {
        replies.set(reply.region, reply)
        tell()
    }

    /** Called by [region]: its command ended with [failure]. */
    fun fail(region: Int, failure: Throwable) {
        failures.set(region, failure)
        tell()
    }

    /** Called by the code that runs [region]: it takes no more commands. */
    fun leave(region: Int) {
        gone.set(region, 1)
        tell()
    }

    /** Whether [region] takes no more commands. An answer may still be here. */
    fun hasLeft(region: Int): Boolean = gone.get(region) != 0

    /** Whether an answer of [region] is here. */
    fun has(region: Int): Boolean = replies.get(region) != null || failures.get(region) != null

    /** Takes the answer of [region] to a command of [phase]; null when there is none. */
    fun take(region: Int, phase: Phase): RegionReply? {
        replies.getAndSet(region, null)?.let { return it }
        return failures.getAndSet(region, null)?.let { RegionReply(region, phase, failure = it) }
    }

    private fun tell() {
        counted.incrementAndGet()
        try {
            waker.wake()
        } catch (e: Throwable) {
            // Out of memory, for example. The waiting thread looks again after a slice of time.
        }
    }
}

/** Wakes a coordinator that waits. From any thread; a call is not lost when it does not wait yet. */
internal fun interface Waker {
    fun wake()
}
