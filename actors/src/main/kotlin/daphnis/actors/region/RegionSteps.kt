package daphnis.actors.region

import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonSteps
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.step.CollisionStep
import java.util.concurrent.CancellationException
import java.util.concurrent.Semaphore
import java.util.concurrent.locks.LockSupport

/**
 * The common part of the engines on regions: a step from its beginning to its end, and the end of the engine.
 *
 * **Two ways of taking a step.** Where it should be quicker, regions share a step of an epoch ([RegionLoop]); else they
 * grow islands ([StepCoordinator]).
 *
 * **How a step ends.** Regions grow islands on paths that are guesses until they have been checked, so an exception out
 * of a region (a collapse, a step that is refused, a law that throws) may come from something that never happens. The
 * step is then left to the serial engine, which is the specification: its result, from the population that no thread
 * has written, is the outcome. An [Error] is passed on at once. After either, all regions are replaced by new ones,
 * since the one that failed may have left shared data incomplete.
 *
 * **How the engine ends.** [close] marks and cancels, and never waits, so it may be called from anywhere, even from a
 * function that a region is calling. The last of the step under way and [close] ends the regions and calls [release].
 *
 * @param threads number of workers to plan for
 * @param inner the loop on the engine's threads
 * @param open starts the regions
 * @param release ends the engine's threads
 */
internal class RegionSteps(
    private val layout: RegionLayout?,
    private val threads: Int,
    private val inner: RangeLoop,
    private val open: (List<Region>, Answers) -> RegionHost,
    private val release: () -> Unit,
) : AutoCloseable {
    /** Held while a step is under way or the engine is being shut down. */
    private val stepping = Semaphore(1)
    private var exchange: StepExchange? = null

    @Volatile
    private var current: StepCoordinator? = null

    /** Called by every region before each command; for tests. Set before the first step. */
    var probe: ((RegionCommand) -> Unit)? = null

    /** The least number of spheres with which steps are taken in epochs. Set before the first step. */
    var fewest: Int = HorizonSteps.WORTH_SPHERES

    /** How epochs are laid out, null for what should be quickest; for tests. Set before the first step. */
    var tuning: HorizonTuning? = null

    /** See [StepExchange]; tests shorten it. Set before the first step. */
    var patience: Long = StepExchange.PATIENCE

    private val gate = ClosableLoop(inner, CLOSED)

    /** The loop on the engine's threads, until it is closed. */
    val loop: RangeLoop get() = gate

    fun requireOpen() {
        gate.requireOpen()
    }

    /** Takes [step] on this thread. An interrupt does not end it; the flag is set again afterwards. */
    fun advance(step: CollisionStep) {
        val thread = Thread.currentThread()
        var isInterrupted = false
        try {
            take(step, { LockSupport.unpark(thread) }, { true }) { exchange ->
                // A wake-up that was consumed while a loop waited is not needed, since then there is news.
                exchange.awaitNews()
                if (Thread.interrupted()) isInterrupted = true
            }
        } finally {
            if (isInterrupted) thread.interrupt()
        }
    }

    /**
     * Takes [step].
     *
     * @param waker ends [await]
     * @param isWanted called at every turn; false cancels the step
     * @param await waits until there is news, but no longer than a slice
     */
    inline fun take(
        step: CollisionStep,
        waker: Waker,
        noinline isWanted: () -> Boolean,
        await: (StepExchange) -> Unit,
    ) {
        val exchange = enter(step.population.size)
        try {
            if (share(exchange, step, isWanted)) return
            if (isOneRegion(exchange)) {
                // As long as it can still be cancelled: the serial engine asks nobody.
                if (!isWanted()) exchange.coordinator.cancel()
                conclude(exchange, step)
                SerialEngine(prepared = exchange.coordinator.prepared).advance(step)
            } else {
                exchange.wakeWith(waker)
                exchange.begin(step)
                while (!exchange.turn()) {
                    exchange.serveOwn()
                    await(exchange)
                    if (!isWanted()) exchange.coordinator.cancel()
                }
                conclude(exchange, step)
            }
            exchange.horizon.tookAnother(step)
        } finally {
            leave(exchange)
        }
    }

    /**
     * Takes [step] in an epoch, on this thread, if that should be quicker.
     *
     * @return whether the step is done
     */
    fun share(exchange: StepExchange, step: CollisionStep, isWanted: () -> Boolean): Boolean {
        val thread = Thread.currentThread()
        exchange.wakeWith { LockSupport.unpark(thread) }
        exchange.loop.beginStep(isWanted)
        try {
            if (!exchange.horizon.take(step, exchange.loop::requireWanted)) return false
        } catch (e: Throwable) {
            if (!exchange.loop.isBroken) throw e
            conclude(exchange, step)
            // Only after a failure of a region was the step taken.
            if (exchange.coordinator.failure == null) throw e
        } finally {
            exchange.loop.endStep()
        }
        return true
    }

    fun enter(spheres: Int): StepExchange {
        requireOpen()
        check(stepping.tryAcquire()) { "a step is under way" }
        try {
            val exchange = exchange ?: newExchange(spheres).also { exchange = it }
            exchange.coordinator.renew()
            current = exchange.coordinator
            // A [close] which does not see the coordinator yet has set the mark before this line.
            if (gate.isClosed) exchange.coordinator.cancel()
            return exchange
        } catch (e: Throwable) {
            leave(exchange)
            throw e
        }
    }

    /** Whether nobody has wanted regions where there are so few spheres that one has all: islands would gain nothing. */
    fun isOneRegion(exchange: StepExchange): Boolean = layout == null && exchange.coordinator.regions.size == 1

    private fun newExchange(spheres: Int): StepExchange {
        val coordinator = StepCoordinator(RegionMap(layout ?: RegionLayout.of(spheres, threads)), inner)
        for (region in coordinator.regions) probe?.let { region.probe = it }
        val answers = Answers(coordinator.regions.size)
        val host = open(coordinator.regions, answers)
        val workers = minOf(coordinator.regions.size, maxOf(threads, MOST_SHARES))
        try {
            return StepExchange(coordinator, answers, host, patience, workers) { HorizonSteps(it, fewest, tuning) }
        } catch (e: Throwable) {
            host.stop()
            throw e
        }
    }

    fun conclude(exchange: StepExchange, step: CollisionStep) {
        val failure = exchange.coordinator.failure
        val lost = exchange.lost
        when {
            failure is Error -> throw failure
            lost is Error -> throw lost
            exchange.coordinator.isCancelled ->
                throw CancellationException(if (gate.isClosed) CLOSED else "the step was cancelled")
            lost != null -> throw lost
            failure != null -> {
                SerialEngine(prepared = exchange.coordinator.prepared).advance(step)
                step.counters.causalityReplays++
            }
        }
    }

    fun leave(exchange: StepExchange?) {
        current = null
        try {
            if (exchange != null && !exchange.isReusable) {
                this.exchange = null
                exchange.stop()
            }
        } finally {
            stepping.release()
            if (gate.isClosed) takeDown()
        }
    }

    /**
     * Called once the engine is closed, by the last of the step and [close]. Throws nothing, since the step that has
     * just been done stays done.
     */
    private fun takeDown() {
        if (!stepping.tryAcquire()) return
        try {
            exchange?.stop()
            exchange = null
            release()
        } catch (e: Throwable) {
            // Out of memory, for example. Closing again tries again.
        } finally {
            stepping.release()
        }
    }

    override fun close() {
        gate.close()
        current?.cancel()
        takeDown()
    }

    private companion object {
        /**
         * Most regions among which loops of epochs are shared where threads are fewer: groups of spheres keep lists for
         * one another, so many take much memory.
         */
        const val MOST_SHARES = 32
        const val CLOSED = "the engine is closed"
    }
}
