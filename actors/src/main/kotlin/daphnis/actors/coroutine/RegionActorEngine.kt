package daphnis.actors.coroutine

import daphnis.actors.region.Coordinator
import daphnis.actors.region.RegionSteps
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.parallel.ExecutorHandler
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.LoopStrategy.DYNAMIC
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.parallel.ThreadHandler
import daphnis.core.step.CollisionStep
import kotlinx.coroutines.CoroutineDispatcher
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.asCoroutineDispatcher
import kotlinx.coroutines.currentCoroutineContext
import kotlinx.coroutines.ensureActive
import kotlinx.coroutines.withContext
import java.util.concurrent.CancellationException
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.atomic.AtomicInteger

/**
 * The steps of `horizon`, shared among coroutines. The spheres are in the order of cells, and each coroutine has a
 * region, the same share of that order from loop to loop. It takes its shares from a channel; the coordinator runs on
 * the thread that calls [advance], or on one of [Dispatchers.IO] for [advanceSuspending], and has a region too. Steps
 * that `horizon` leaves to the serial engine are taken by the coordinator alone. Why nothing deadlocks is in
 * [Coordinator].
 *
 * **Failure.** However a step fails, [advance] throws and leaves the population as before. After an exception in a
 * region the serial engine decides the step, since regions work on guessed paths; an error is passed on. When the
 * dispatcher ends, or gives the regions no thread for 30 s, it throws an [IllegalStateException].
 *
 * **Interrupts, cancelling, closing.** [advance] finishes its step even if its thread is interrupted, and leaves the
 * flag set. [close] returns at once; a step under way ends with a [CancellationException] and the population as before,
 * unless the population is being written already. Afterwards [advance] and [loop] throw an [IllegalStateException].
 *
 * @param threads of the engine's own pool; only the number of workers to plan for when [dispatcher] is given
 * @param regions how many, 1 to 4096; 0 for one per thread, but none with less than 2000 of the spheres of the first
 *   step. No more than 32 are made where threads are not more
 * @param dispatcher where regions run; not closed with the engine
 */
public class RegionActorEngine @JvmOverloads constructor(
    override val threads: Int,
    regions: Int = 0,
    dispatcher: CoroutineDispatcher? = null,
) : CollisionEngine {
    override val name: String get() = "actors"

    init {
        require(threads in 1..ThreadHandler.MOST) { "threads is $threads; it must be in 1..${ThreadHandler.MOST}" }
    }

    private val pool: ExecutorService? = if (dispatcher == null) newPool(threads) else null
    private val regionThreads = dispatcher ?: pool!!.asCoroutineDispatcher()
    private val steps = RegionSteps(
        regions,
        threads,
        if (pool == null || threads == 1) InlineLoop else ParallelLoop(ExecutorHandler(pool, threads), DYNAMIC),
        { regions, answers -> CoroutineRegions(regionThreads, regions, answers) },
        { pool?.shutdown() },
    )
    override val loop: RangeLoop get() = steps.loop

    /** Called by every region, with its number, before each share; for tests. Set before the first step. */
    internal var probe: ((Int) -> Unit)? by steps::probe

    /** The least number of spheres with which steps are taken in epochs; for tests. Set before the first step. */
    internal var fewest: Int by steps::fewest
    internal var tuning: HorizonTuning? by steps::tuning

    /** Nanoseconds after which a step in which nothing begins counts as lost; for tests. Set before the first step. */
    internal var patience: Long by steps::patience

    override fun advance(step: CollisionStep) {
        steps.advance(step)
    }

    /**
     * [advance] for a coroutine that may be cancelled. When it is cancelled, this ends soon with a
     * [CancellationException] and the population as before, unless the population is being written already. In that
     * case the step is finished and this returns. One caller at a time. The coordinator's share of the work, and that
     * of the first region, is done on [Dispatchers.IO], on threads that regions there do not need.
     */
    public suspend fun advanceSuspending(step: CollisionStep) {
        currentCoroutineContext().ensureActive()
        val caller = currentCoroutineContext()[Job]
        // Twice, since a change of dispatcher checks on return whether the job around it is cancelled, and would
        // discard a step that is done.
        withContext(NonCancellable) {
            withContext(COORDINATORS) { steps.advance(step) { caller?.isActive != false } }
        }
    }

    override fun close() {
        steps.close()
    }

    private companion object {
        /** They block while they wait for regions, so they must not take the threads of a user's dispatcher. */
        val COORDINATORS = Dispatchers.IO.limitedParallelism(64)

        fun newPool(threads: Int): ExecutorService {
            val number = AtomicInteger()
            return Executors.newFixedThreadPool(threads) {
                Thread(it, "daphnis-actors-${number.incrementAndGet()}").apply {
                    isDaemon =
                        true
                }
            }
        }
    }
}
