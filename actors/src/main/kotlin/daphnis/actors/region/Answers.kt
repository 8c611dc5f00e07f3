package daphnis.actors.region

import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicIntegerArray
import java.util.concurrent.atomic.AtomicReferenceArray

/**
 * The coordinator's mailbox: room for one answer of each region, since a region gets its next command only after it has
 * answered the last one. Putting an answer in allocates nothing, waits for nobody and throws nothing, so a region can
 * say even that it ran out of memory.
 *
 * Hand-over: reply filled → put in its place (volatile) → taken by the coordinator → read.
 */
internal class Answers(count: Int) {
    private val replies = AtomicReferenceArray<RegionReply?>(count)
    private val failures = AtomicReferenceArray<Throwable?>(count)
    private val gone = AtomicIntegerArray(count)
    private val counted = AtomicInteger()

    /** Wakes who waits for answers. Written before the first command of a step is sent. */
    @Volatile
    var waker: Waker = Waker { }

    /** How many have come since the start, with the regions that have gone. */
    val count: Int get() = counted.get()

    /** From a region: [reply] to its command. */
    fun put(reply: RegionReply) {
        replies.set(reply.region, reply)
        tell()
    }

    /** From [region]: its command ended with [failure]. */
    fun fail(region: Int, failure: Throwable) {
        failures.set(region, failure)
        tell()
    }

    /** From whoever runs [region]: it takes no more commands. */
    fun leave(region: Int) {
        gone.set(region, 1)
        tell()
    }

    /** Whether [region] takes no more commands. An answer may still lie here. */
    fun hasLeft(region: Int): Boolean = gone.get(region) != 0

    /** Whether an answer of [region] lies here. */
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
            // Out of memory, say. Who waits looks again after a slice of time.
        }
    }
}

/** Wakes a coordinator that waits. From any thread; a call when nobody waits is not lost. */
internal fun interface Waker {
    fun wake()
}
