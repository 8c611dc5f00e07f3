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
internal class RegionLoop(private val exchange: StepExchange) : RangeLoop {
    override val workers: Int = exchange.coordinator.regions.size

    private var isWanted: () -> Boolean = { true }
    private var isInterrupted = false

    /** Whether a region has thrown something in this step, or regions were lost, or it was cancelled. */
    var isBroken = false
        private set

    /** Begins a step on this thread, which is cancelled when [isWanted] says no. */
    fun beginStep(isWanted: () -> Boolean) {
        this.isWanted = isWanted
        isInterrupted = false
        isBroken = false
    }

    fun endStep() {
        isWanted = { true }
        if (isInterrupted) Thread.currentThread().interrupt()
    }

    /**
     * @throws CancellationException when the step was cancelled
     * @throws IllegalStateException when the regions cannot answer, see [StepExchange]
     * @throws Throwable what a region threw
     */
    override fun run(size: Int, grain: Int, body: RangeBody) {
        if (size <= 0) return
        if (size <= grain) {
            body.run(0, 0, size)
            return
        }
        val loop = SharedLoop(body)
        isBroken = true
        exchange.share(size, loop)
        while (!exchange.turn()) {
            exchange.serveOwn()
            exchange.awaitNews()
            if (Thread.interrupted()) isInterrupted = true
            if (!isWanted()) exchange.coordinator.cancel()
        }
        if (exchange.lost != null) exchange.abandon(loop)
        exchange.throwFailure()
        isBroken = false
    }
}
