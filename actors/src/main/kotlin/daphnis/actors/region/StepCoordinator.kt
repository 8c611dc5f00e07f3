package daphnis.actors.region

import daphnis.core.engine.islands.IslandField
import daphnis.core.engine.islands.IslandWorkers
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep

/**
 * The coordinator of a step as a state machine, without any framework: it returns what to send and is given what comes
 * back. Physics and proof are those of [IslandField]. Regions are its workers, with the difference that a region
 * touches only its own spheres unless it has been granted others.
 *
 * ```
 *   SEARCH ─▶ for each window: PROPOSE ─▶ join seeds across borders ─▶ WORK ─▶ GRANT … ─▶ CHECK ─▶ COMMIT ─▶ LOOK_AHEAD
 *                                                                             ▲            │
 *                                                                             └─ islands that touch, merged
 * ```
 *
 * A new phase begins when all regions have answered the last one. GRANT is an exception: batches are sent as locks
 * become free ([BorderIslands]).
 *
 * **Nothing deadlocks with full mailboxes**: a region gets a command only when it has answered the one before, so its
 * mailbox never holds more than one; it answers each once, so the coordinator's mailbox never holds more than one per
 * region. With these capacities no send ever waits. The coordinator waits only for answers to commands that have been
 * sent, and a region answers without waiting for anything.
 *
 * Single-threaded: calls come one after the other, and each happens after the one before.
 */
public class StepCoordinator @JvmOverloads constructor(
    public val map: RegionMap,
    private val loop: RangeLoop = InlineLoop,
) {
    /** The present step; for the serial engine too, once no region is at work. */
    internal val prepared: PreparedStep = PreparedStep()
    private val field = IslandField(map.count, prepared)
    private val workers = IslandWorkers(field, map.count)
    private val border = BorderIslands(map, workers)
    private val outbox = ArrayDeque<RegionCommand>()
    private var step: CollisionStep? = null
    private var phase = Phase.SEARCH
    private var outstanding = 0

    /** How often the present step was redone because a sphere went beyond its bound. */
    private var redone = 0L

    /** The regions, for the code that runs them. */
    public val regions: List<Region> = List(map.count) { Region(it, map, workers) }

    /** Whether the step has ended, successfully or not. */
    public var isFinished: Boolean = true
        private set

    /**
     * What a region threw, or the coordinator's own work: an [Error] if there was any, otherwise the first exception;
     * null after success.
     */
    public var failure: Throwable? = null
        private set

    @Volatile
    private var cancelled = false
    private var isStored = false

    /** Whether [cancel] keeps or kept the step from succeeding. */
    public val isCancelled: Boolean get() = cancelled && !isStored

    /** Begins [step]; may be called again for the same step after a failure. */
    public fun begin(step: CollisionStep) {
        renew()
        beginGrowing(step)
    }

    /** Forgets the last step, and whether it was cancelled. */
    internal fun renew() {
        check(outstanding == 0) { "a step is under way" }
        failure = null
        cancelled = false
        isStored = false
    }

    /**
     * Shares the indices 0 until [size] of [loop] among the first [parts] regions, in order, for a step that is taken
     * in an epoch. It [isFinished] when all have answered.
     */
    internal fun share(size: Int, loop: SharedLoop, parts: Int = map.count) {
        check(outstanding == 0) { "a step is under way" }
        isFinished = false
        phase = Phase.SHARE
        val indices = size.toLong()
        for (region in 0 until parts) {
            val from = (indices * region / parts).toInt()
            val to = (indices * (region + 1) / parts).toInt()
            send(RegionCommand(region, Share(loop, from, to)))
        }
    }

    /** Begins [step] by islands, after [renew]. */
    internal fun beginGrowing(step: CollisionStep) {
        check(outstanding == 0) { "a step is under way" }
        this.step = step
        isFinished = false
        redone = 0
        guarded {
            field.measure(step, loop)
            attempt()
        }
    }

    private fun attempt() {
        val step = step!!
        field.prepare(loop)
        workers.prepare()
        map.prepare(field.rows, field.grid, step.boundary)
        border.clear()
        sendAll(Phase.SEARCH)
    }

    /** The next command to send, null when there is none now. */
    public fun poll(): RegionCommand? = outbox.removeFirstOrNull()

    /**
     * Makes the step end as soon as the regions have answered their present commands, with the population as before.
     * From any thread. Once the population is being written the step has succeeded, and this does nothing.
     */
    public fun cancel() {
        cancelled = true
        field.stop()
    }

    /** Makes the regions stop their present work; for a step that has failed. From any thread. */
    internal fun stopWork() {
        field.stop()
    }

    /** Takes the answer of a region. */
    public fun accept(reply: RegionReply) {
        outstanding--
        if (reply.failure != null) fail(reply.failure)
        if (failure != null || cancelled) giveUp() else guarded { follow(reply) }
    }

    private fun follow(reply: RegionReply) {
        when (reply.phase) {
            Phase.WORK -> for (k in 0 until reply.border.size / 2) {
                border.add(reply.border[2 * k], reply.border[2 * k + 1], null)
            }
            Phase.GRANT -> {
                border.returned(reply)
                if (!field.isOutrun) border.grant(::send)
            }
            else -> Unit
        }
        if (outstanding == 0) goOn()
    }

    /** An exception from the coordinator's own work ends the step as one from a region does: when all have answered. */
    private inline fun guarded(work: () -> Unit) {
        try {
            work()
        } catch (e: Throwable) {
            fail(e)
            giveUp()
        }
    }

    private fun fail(e: Throwable) {
        if (failure == null || e is Error && failure !is Error) failure = e
        field.stop()
    }

    /** Sends no more commands; the step has ended when all regions have answered. */
    private fun giveUp() {
        outstanding -= outbox.size
        outbox.clear()
        if (outstanding == 0) isFinished = true
    }

    /** Called when all regions have answered. */
    private fun goOn() {
        if (phase != Phase.SHARE && field.isOutrun) {
            field.enlarge()
            redone++
            attempt()
            return
        }
        when (phase) {
            Phase.SHARE -> isFinished = true
            Phase.SEARCH -> openWindow()
            Phase.PROPOSE -> {
                workers.joinBorders()
                for (k in 0 until workers.rootCount) border.add(workers.root(k), NOBODY, null)
                sendAll(Phase.WORK)
            }
            Phase.WORK, Phase.GRANT -> if (border.isEmpty) sendAll(Phase.CHECK) else grant()
            Phase.CHECK ->
                if (workers.mergeConflicts()) {
                    for (k in 0 until workers.rootCount) border.add(workers.root(k), NOBODY, null)
                    grant()
                } else {
                    sendAll(Phase.COMMIT)
                }
            Phase.COMMIT -> if (workers.isLastWindow) closeWindow() else sendAll(Phase.LOOK_AHEAD)
            Phase.LOOK_AHEAD -> closeWindow()
        }
    }

    private fun grant() {
        phase = Phase.GRANT
        border.grant(::send)
    }

    private fun closeWindow() {
        workers.closeWindow()
        openWindow()
    }

    private fun openWindow() {
        while (!workers.isLastWindow) {
            if (workers.openWindow() > 0) {
                sendAll(Phase.PROPOSE)
                return
            }
        }
        finish(step!!)
    }

    /** The population is written last. Nothing after that can fail, and nothing after that checks [cancel]. */
    private fun finish(step: CollisionStep) {
        workers.writeTo(step.record)
        if (!cancelled) {
            field.store(loop)
            isStored = true
            step.counters.redoneSteps += redone
            workers.addTo(step.counters)
        }
        isFinished = true
    }

    private fun sendAll(next: Phase) {
        phase = next
        for (region in 0 until map.count) send(RegionCommand(region, next))
    }

    private fun send(command: RegionCommand) {
        outbox.addLast(command)
        outstanding++
    }

    private companion object {
        const val NOBODY = -1
    }
}
