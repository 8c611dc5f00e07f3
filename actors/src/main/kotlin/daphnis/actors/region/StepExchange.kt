package daphnis.actors.region

import daphnis.core.engine.horizon.HorizonSteps
import daphnis.core.parallel.RangeLoop
import daphnis.core.step.CollisionStep
import java.util.concurrent.CancellationException
import java.util.concurrent.locks.LockSupport

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
 * @param workers among how many regions the loops of epochs are shared
 * @param epochs makes the steps in epochs, whose loop is that of the regions
 */
internal class StepExchange(
    val coordinator: StepCoordinator,
    private val answers: Answers,
    private val host: RegionHost,
    private val patience: Long,
    workers: Int,
    epochs: (RangeLoop) -> HorizonSteps,
) {
    private val out = arrayOfNulls<RegionCommand>(coordinator.regions.size)
    private var own: RegionCommand? = null
    private var seen = 0
    private var idle = 0L
    private var lastLook = 0L

    /** Waits until there is news, or an interrupt, but no longer than a slice. Blocks this thread. */
    fun awaitNews() {
        var spins = 0
        while (!hasNews && spins < SPINS) {
            spins++
            Thread.onSpinWait()
        }
        if (!hasNews) LockSupport.parkNanos(this, SLICE)
    }

    /** Why answers will not come; null while they may. */
    var lost: Throwable? = null
        private set

    /** Whether the regions can take another step: all have answered, and none has failed. */
    val isReusable: Boolean get() = coordinator.isFinished && coordinator.failure == null && lost == null

    /** Whether something has come since the last turn. */
    val hasNews: Boolean get() = answers.count != seen

    /** The epochs of these regions. */
    val loop = RegionLoop(this, workers)
    val horizon = epochs(loop)

    /** [waker] wakes the thread or coroutine that waits between two turns from now on. */
    fun wakeWith(waker: Waker) {
        answers.waker = waker
    }

    /** Begins [step] by islands, see [StepCoordinator.beginGrowing]. */
    fun begin(step: CollisionStep) {
        startWatch()
        coordinator.beginGrowing(step)
    }

    /** Begins [loop], see [StepCoordinator.share]. */
    fun share(size: Int, loop: SharedLoop) {
        startWatch()
        coordinator.share(size, loop, this.loop.workers)
    }

    private fun startWatch() {
        idle = 0
        lastLook = System.nanoTime()
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
            if (command.region == OWN && command.phase != Phase.GRANT) own = command else host.send(command)
        }
    }

    /**
     * Does what was sent to one of the regions, on this thread, which would only wait otherwise. Called between two
     * turns, when the others have got their commands.
     */
    fun serveOwn() {
        val command = own ?: return
        own = null
        coordinator.regions[OWN].serve(command, answers)
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

    /** Throws what has ended the step, if anything has. */
    fun throwFailure() {
        val failure = coordinator.failure
        val lost = lost
        when {
            failure is Error -> throw failure
            lost is Error -> throw lost
            coordinator.isCancelled -> throw CancellationException("the step was cancelled")
            lost != null -> throw lost
            failure != null -> throw failure
        }
    }

    /** Waits until no region is at work on [loop], which does not come to its end; none begins any more. */
    fun abandon(loop: SharedLoop) {
        loop.isAbandoned = true
        // A region is at work before it looks whether the loop is abandoned.
        while (coordinator.regions.any { it.isAtWork }) LockSupport.parkNanos(this, SLICE / SLICES_A_LOOK)
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

        /**
         * The region that works on the coordinator's thread, but not under locks: these are returned as soon as others
         * have done with theirs, so the coordinator must look.
         */
        private const val OWN = 0

        /** Some tens of microseconds. */
        private const val SPINS = 2000

        private const val NANOS_A_SECOND = 1e9
        private const val SLICES_A_LOOK = 100
    }
}
