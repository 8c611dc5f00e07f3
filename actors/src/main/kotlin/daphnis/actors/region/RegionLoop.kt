package daphnis.actors.region

import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop
import java.util.concurrent.CancellationException

/**
 * A loop whose indices are shared among the regions, for steps that are taken in epochs
 * ([daphnis.core.engine.horizon.HorizonSteps]): the spheres are in the order of cells, so each region works on the same
 * part of space from loop to loop, and processes the collisions there. What crosses borders comes back to the
 * coordinator, which takes it in order of time.
 *
 * The thread that calls [run] is the coordinator's. It does one region's share itself and waits until all regions have
 * answered, whatever one of them has thrown, so nothing is written any more when [run] has ended. An interrupt does not
 * end the wait; [endStep] sets the flag again.
 */
internal class RegionLoop(private val coordinator: Coordinator) : RangeLoop {
    override val workers: Int get() = coordinator.count
    private var isWanted: () -> Boolean = { true }
    private var isInterrupted = false

    /** Begins a step on this thread, which is cancelled when [isWanted] says no. */
    fun beginStep(isWanted: () -> Boolean) {
        this.isWanted = isWanted
        isInterrupted = false
    }

    /**
     * Asked before each loop, and before the population is written: much may happen on this thread alone.
     *
     * @throws CancellationException when the step was cancelled
     */
    fun requireWanted() {
        ask()
        coordinator.requireWanted()
    }

    private fun ask() {
        if (!isWanted()) coordinator.cancel("the step was cancelled")
    }

    fun endStep() {
        isWanted = { true }
        if (isInterrupted) Thread.currentThread().interrupt()
    }

    /**
     * @throws CancellationException when the step was cancelled
     * @throws IllegalStateException when the regions cannot answer, see [Coordinator]
     * @throws Throwable what a region threw
     */
    override fun run(size: Int, grain: Int, body: RangeBody) {
        if (size <= 0) return
        requireWanted()
        if (size <= grain) {
            body.run(0, 0, size)
            return
        }
        val loop = SharedLoop(body)
        try {
            coordinator.share(size, loop)
            while (!coordinator.turn()) {
                coordinator.serveOwn()
                coordinator.awaitNews()
                if (Thread.interrupted()) isInterrupted = true
                ask()
            }
        } catch (e: Throwable) {
            // The coordinator's own part, out of memory or stack for example.
            coordinator.abandon(loop)
            throw e
        }
        if (coordinator.lost != null) coordinator.abandon(loop)
        coordinator.throwFailure()
    }
}
