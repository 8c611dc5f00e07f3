package daphnis.actors.region

import daphnis.core.step.CollisionStep

/**
 * The coordinator's loop, one [turn] at a time, on the thread or coroutine that takes the step: it sends commands to
 * the regions and takes answers. Between two turns it waits until an answer has come, but no longer than a slice of
 * time, since **no wait may depend on an answer alone**: the region that should give it may be dead.
 *
 * A region answers whatever it throws ([Region.serve]). What no answer can tell is observed from outside: the region's
 * actor has ended, or its host has ended, or commands are out, no region is at work and none has begun for [patience].
 * Then the step ends as [lost].
 *
 * @param patience in nanoseconds of waiting; time in which the process itself was stopped does not count
 */
internal class StepExchange(
    val coordinator: StepCoordinator,
    private val answers: Answers,
    private val host: RegionHost,
    private val patience: Long,
) {
    private val out = arrayOfNulls<RegionCommand>(coordinator.regions.size)
    private var seen = 0
    private var idle = 0L
    private var lastLook = 0L

    /** Why answers will not come; null while they may. */
    var lost: Throwable? = null
        private set

    /** Whether the regions can take another step: all have answered, and none has failed. */
    val isReusable: Boolean get() = coordinator.isFinished && coordinator.failure == null && lost == null

    /** Whether something has come since the last turn. */
    val hasNews: Boolean get() = answers.count != seen

    /** Begins [step]; [waker] wakes the thread or coroutine that waits between two turns. */
    fun begin(step: CollisionStep, waker: Waker) {
        answers.waker = waker
        idle = 0
        lastLook = System.nanoTime()
        coordinator.begin(step)
    }

    /**
     * Takes the answers that have come and sends the commands that follow from them.
     *
     * @return whether the step has come to an end
     */
    fun turn(): Boolean {
        val isNews = hasNews
        if (isNews) takeAnswers()
        try {
            sendAll()
        } catch (e: Throwable) {
            coordinator.stopWork()
            lost = e
        }
        if (coordinator.isFinished || lost != null) return true
        if (isNews) idle = 0 else watch()
        return lost != null
    }

    private fun takeAnswers() {
        // Read before the answers are, so that an answer that comes in between causes another turn.
        seen = answers.count
        for (region in out.indices) {
            val command = out[region] ?: continue
            val reply = answers.take(region, command.phase) ?: continue
            out[region] = null
            coordinator.accept(reply)
        }
    }

    private fun sendAll() {
        while (true) {
            val command = coordinator.poll() ?: return
            out[command.region] = command
            host.send(command)
        }
    }

    /** Called when nothing has come: checks whether anything still can. */
    private fun watch() {
        val now = System.nanoTime()
        idle += minOf(now - lastLook, SLICE)
        lastLook = now
        var isAtWork = false
        var isGone = false
        val hasEnded = host.hasEnded
        for (region in out.indices) {
            if (out[region] == null) continue
            // In this order: a region that has left begins nothing more; if it is then not at work, it has answered or
            // never will.
            val hasLeft = hasEnded || answers.hasLeft(region)
            if (coordinator.regions[region].isAtWork) {
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

    /** Ends the regions. */
    fun stop() {
        host.stop()
    }

    companion object {
        /** Nanoseconds to wait at most between two turns. */
        const val SLICE = 100_000_000L

        /** Nanoseconds after which a step in which nothing begins counts as lost. */
        const val PATIENCE = 30_000_000_000L

        private const val NANOS_A_SECOND = 1e9
    }
}
