package daphnis.actors.region

import java.util.concurrent.CancellationException
import java.util.concurrent.locks.LockSupport

/**
 * Shares loops among regions, one loop after the other: a state machine without any framework, one [turn] at a time, on
 * the thread that takes the step.
 *
 * ```
 *   all have answered ──share──▶ some have not ──turn…──▶ all have answered
 *                                      └──────────turn──▶ lost: an answer will not come
 * ```
 *
 * **Every wait has an end.** Between two turns the thread waits until an answer has come, but no longer than a slice of
 * time, since no wait may depend on an answer alone: the region that should give it may be dead. A region answers
 * whatever it throws ([Region.serve]). What no answer can tell is observed from outside: the region's actor has ended,
 * or its host has ended, or shares are out, no region is at work and none has begun for [patience]. Then the loop ends
 * as [lost].
 *
 * **Nothing deadlocks with full mailboxes**: a region gets a share only when it has answered the one before, so its
 * mailbox never holds more than one; it answers each once, so [Answers] never hold more than one per region. With these
 * capacities no send ever waits, and a region answers without waiting for anything.
 *
 * Single-threaded except for [cancel].
 *
 * @param patience in nanoseconds of waiting; time in which the process itself was stopped does not count
 */
internal class Coordinator(
    private val regions: List<Region>,
    private val answers: Answers,
    private val host: RegionHost,
    private val patience: Long,
) {
    /** Number of regions. */
    val count: Int get() = regions.size

    /** By region: whether it has a share that it has not answered. */
    private val isOut = BooleanArray(count)
    private var outstanding = 0

    /** The share of the region that works on this thread. */
    private var own: Share? = null
    private var seen = 0
    private var idle = 0L
    private var lastLook = 0L

    /** What a region threw: an [Error] if there was any, otherwise the first exception; null when none did. */
    var failure: Throwable? = null
        private set

    /** Why answers will not come; null while they may. */
    var lost: Throwable? = null
        private set

    /** Why the step is not wanted any more; null while it is. */
    @Volatile
    private var cancelled: String? = null

    /** Whether the regions can take another step: all have answered, and none has failed. */
    val isReusable: Boolean get() = outstanding == 0 && failure == null && lost == null

    /** Begins a step on this thread, which is not cancelled yet. */
    fun begin() {
        check(isReusable) { "the regions of a step that failed" }
        cancelled = null
        answers.reader = Thread.currentThread()
    }

    /**
     * Ends the step as soon as the regions have answered their present shares, with the population as before; [why] is
     * the message. From any thread. Once the population is being written this does nothing.
     */
    fun cancel(why: String) {
        cancelled = why
    }

    /** @throws CancellationException after [cancel] */
    fun requireWanted() {
        val why = cancelled ?: return
        throw CancellationException(why)
    }

    /** Shares the indices 0 until [size] of [loop] among the regions, in order. They are done when [turn] says so. */
    fun share(size: Int, loop: SharedLoop) {
        check(outstanding == 0) { "a loop is under way" }
        idle = 0
        lastLook = System.nanoTime()
        outstanding = count
        isOut.fill(true)
        try {
            for (region in regions.indices) {
                val share = Share(loop, indexAt(region, size), indexAt(region + 1, size))
                if (region == OWN) own = share else host.send(region, share)
            }
        } catch (e: Throwable) {
            lost = e
        }
    }

    private fun indexAt(region: Int, size: Int) = (size.toLong() * region / count).toInt()

    /**
     * Takes the answers that have come.
     *
     * @return whether the loop has come to an end
     */
    fun turn(): Boolean {
        if (lost != null) return true
        if (hasNews) takeAnswers() else watch()
        return outstanding == 0 || lost != null
    }

    /** Whether something has come since the last turn. */
    private val hasNews: Boolean get() = answers.count != seen

    private fun takeAnswers() {
        // Read before the answers are, so that an answer that comes in between causes another turn.
        seen = answers.count
        idle = 0
        for (region in isOut.indices) {
            answers.take(region) { thrown ->
                isOut[region] = false
                outstanding--
                if (failure == null || thrown is Error && failure !is Error) failure = thrown
            }
        }
    }

    /**
     * Does the share of one of the regions on this thread, which would only wait otherwise. Called between two turns,
     * when the others have got theirs.
     */
    fun serveOwn() {
        val share = own ?: return
        own = null
        regions[OWN].serve(share, answers)
    }

    /** Waits until there is news, or an interrupt, but no longer than a slice. Blocks this thread. */
    fun awaitNews() {
        var spins = 0
        while (!hasNews && spins < SPINS) {
            spins++
            Thread.onSpinWait()
        }
        if (!hasNews) LockSupport.parkNanos(this, SLICE)
    }

    /** Called when nothing has come: checks whether anything still can. */
    private fun watch() {
        val now = System.nanoTime()
        idle += minOf(now - lastLook, SLICE)
        lastLook = now
        var isAtWork = false
        var isGone = false
        val hasEnded = host.hasEnded
        for (region in isOut.indices) {
            if (!isOut[region]) continue
            // In this order: a region that has left begins nothing more; if it is then not at work, it has answered or
            // never will.
            val hasLeft = hasEnded || answers.hasLeft(region)
            if (regions[region].isAtWork) {
                isAtWork = true
            } else if (hasLeft && !answers.has(region)) {
                isGone = true
            }
        }
        if (isAtWork) {
            idle = 0
        } else if (isGone) {
            lost = IllegalStateException(
                "regions have ended in the middle of a step: ${host.name} was shut down, or ran out of memory",
            )
        } else if (idle > patience) {
            lost = IllegalStateException(
                "no region has begun its work for ${patience / NANOS_A_SECOND} s: " +
                    "the threads of ${host.name} are dead, or busy with something else",
            )
        }
    }

    /** Throws what has ended the loop before its end, if anything has. */
    fun throwFailure() {
        val failure = failure
        val lost = lost
        if (failure is Error) throw failure
        if (lost is Error) throw lost
        requireWanted()
        throw lost ?: failure ?: return
    }

    /** Waits until no region is at work on [loop], which does not come to its end; none begins any more. */
    fun abandon(loop: SharedLoop) {
        loop.isAbandoned = true
        // A region is at work before it looks whether the loop is abandoned.
        while (regions.any { it.isAtWork }) LockSupport.parkNanos(this, SLICE / SLICES_A_LOOK)
    }

    /** Ends the regions. */
    fun stop() {
        host.stop()
    }

    companion object {
        /** Nanoseconds after which a loop in which nothing begins counts as lost. */
        const val PATIENCE = 30_000_000_000L

        /** Nanoseconds to wait at most between two turns. */
        private const val SLICE = 100_000_000L

        /** The region that works on the coordinator's thread. */
        private const val OWN = 0

        /** Some tens of microseconds. */
        private const val SPINS = 2000

        private const val NANOS_A_SECOND = 1e9
        private const val SLICES_A_LOOK = 100
    }
}
