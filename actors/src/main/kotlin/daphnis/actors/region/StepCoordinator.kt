package daphnis.actors.region

import daphnis.core.engine.CollisionStep
import daphnis.core.engine.islands.IslandCrew
import daphnis.core.engine.islands.IslandField
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop

/**
 * The coordinator of a step as a state machine, without any framework: tells what to send and is told what comes back. Physics and proof are those of
 * [IslandField]; regions are its workers, with the difference that a region touches its own spheres only, unless it has been granted others.
 *
 * ```
 *   SEARCH ─▶ for each window: PROPOSE ─▶ join seeds across borders ─▶ WORK ─▶ GRANT … ─▶ CHECK ─▶ COMMIT ─▶ LOOK_AHEAD
 *                                                                             ▲            │
 *                                                                             └─ islands that touch, merged
 * ```
 *
 * A new phase begins when all regions have answered the last one, except within GRANT, where batches go out as locks become free ([BorderIslands]).
 *
 * **Nothing deadlocks with full mailboxes**: a region gets a command only when it has answered the one before, so its mailbox never holds more than one;
 * it answers each once, so the coordinator's never holds more than one a region. With these capacities no send ever waits. The coordinator waits
 * only for answers to commands that have been sent, and a region answers without waiting for anybody.
 *
 * Single-threaded: calls come one after the other, each happening after the one before.
 */
public class StepCoordinator(public val map: RegionMap, private val loop: RangeLoop = InlineLoop) {
    private val field = IslandField(map.count)
    private val crew = IslandCrew(field, map.count)
    private val border = BorderIslands(map, crew)
    private val outbox = ArrayDeque<RegionCommand>()
    private var step: CollisionStep? = null
    private var phase = Phase.SEARCH
    private var outstanding = 0

    /** How often the step at hand was redone because a sphere outran its bound. */
    private var redone = 0L

    /** The regions, for whoever runs them. */
    public val regions: List<Region> = List(map.count) { Region(it, map, crew) }

    /** Whether the step has come to an end, well or not. */
    public var isFinished: Boolean = true
        private set

    /** What the first region that failed threw; null when none did. */
    public var failure: Throwable? = null
        private set

    @Volatile
    private var cancelled = false

    /** Whether [cancel] ended the step. */
    public val isCancelled: Boolean get() = cancelled

    /** Begins [step]; may be called again for the same step after a failure. */
    public fun begin(step: CollisionStep) {
        check(outstanding == 0) { "a step is under way" }
        this.step = step
        failure = null
        cancelled = false
        isFinished = false
        redone = 0
        field.measure(step, loop)
        attempt()
    }

    private fun attempt() {
        val step = step!!
        field.prepare(step, loop)
        crew.prepare()
        map.prepare(field.rows, field.grid, step.boundary)
        border.clear()
        sendAll(Phase.SEARCH)
    }

    /** The next command to send, null when there is none now. */
    public fun poll(): RegionCommand? = outbox.removeFirstOrNull()

    /** Makes the step end as soon as the regions have answered what they were asked. From any thread. */
    public fun cancel() {
        cancelled = true
        field.stop()
    }

    /** Takes the answer of a region. */
    public fun accept(reply: RegionReply) {
        outstanding--
        if (reply.failure != null) {
            failure?.addSuppressed(reply.failure) ?: run { failure = reply.failure }
            field.stop()
        }
        if (failure != null || cancelled) {
            outstanding -= outbox.size
            outbox.clear()
            if (outstanding == 0) isFinished = true
            return
        }
        when (reply.phase) {
            Phase.WORK -> for (k in 0 until reply.border.size / 2) border.add(reply.border[2 * k], reply.border[2 * k + 1], null)
            Phase.GRANT -> {
                border.returned(reply)
                if (!field.isOutrun) border.grant(::send)
            }
            else -> Unit
        }
        if (outstanding == 0) goOn()
    }

    /** All have answered. */
    private fun goOn() {
        if (field.isOutrun) {
            field.enlarge()
            redone++
            attempt()
            return
        }
        when (phase) {
            Phase.SEARCH -> openWindow()
            Phase.PROPOSE -> {
                crew.joinBorders()
                for (k in 0 until crew.rootCount) border.add(crew.roots[k], NOBODY, null)
                sendAll(Phase.WORK)
            }
            Phase.WORK, Phase.GRANT -> if (border.isEmpty) sendAll(Phase.CHECK) else grant()
            Phase.CHECK ->
                if (crew.mergeConflicts()) {
                    for (k in 0 until crew.rootCount) border.add(crew.roots[k], NOBODY, null)
                    grant()
                } else {
                    sendAll(Phase.COMMIT)
                }
            Phase.COMMIT -> if (crew.isLastWindow) closeWindow() else sendAll(Phase.LOOK_AHEAD)
            Phase.LOOK_AHEAD -> closeWindow()
        }
    }

    private fun grant() {
        phase = Phase.GRANT
        border.grant(::send)
    }

    private fun closeWindow() {
        crew.closeWindow()
        openWindow()
    }

    private fun openWindow() {
        while (!crew.isLastWindow) {
            if (crew.openWindow() > 0) {
                sendAll(Phase.PROPOSE)
                return
            }
        }
        val step = step!!
        crew.writeTo(step.record)
        field.store(step, loop)
        step.counters.redoneSteps += redone
        crew.addTo(step.counters)
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
