package daphnis.actors.pekko

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
import org.apache.pekko.actor.typed.ActorSystem
import java.util.concurrent.CancellationException

/**
 * The steps of `horizon`, shared among Apache Pekko typed actors. The spheres are in the order of cells, and each actor
 * has a region, the same share of that order from loop to loop. The coordinator runs on the thread that calls
 * [advance], and has a region too. Steps that `horizon` leaves to the serial engine are taken by the coordinator alone.
 * Why nothing deadlocks is in [Coordinator].
 *
 * [advance] blocks its caller, so call it from a thread that no actor of the system needs. It finishes its step even if
 * its thread is interrupted. However a step fails, it throws and leaves the population as before. After an exception in
 * a region the serial engine decides the step, since regions work on guessed paths; an error is passed on. When the
 * actor system ends, or gives the regions no thread for 30 s, [advance] throws an [IllegalStateException].
 *
 * [close] returns at once; a step under way ends with a [CancellationException] and the population as before, unless
 * the population is being written already. The actors stop, and so does the actor system if it is the engine's own.
 * Afterwards [advance] and [loop] throw an [IllegalStateException].
 *
 * @param threads of the engine's own actor system; only the number of workers to plan for when [host] is given
 * @param regions how many, 1 to 4096; 0 for one per thread, but none with less than 2000 of the spheres of the first
 *   step. No more than 32 are made where threads are not more
 * @param host an actor system to run in; the engine's actors are system actors there and run on its default dispatcher.
 *   When null, the engine starts its own at the first step
 */
public class PekkoEngine @JvmOverloads constructor(
    override val threads: Int,
    regions: Int = 0,
    host: ActorSystem<*>? = null,
) : CollisionEngine {
    override val name: String get() = "pekko"

    init {
        require(threads in 1..ThreadHandler.MOST) { "threads is $threads; it must be in 1..${ThreadHandler.MOST}" }
    }

    private val own = if (host == null) OwnSystem(threads) else null
    private val steps = RegionSteps(
        regions,
        threads,
        if (own == null || threads == 1) InlineLoop else ParallelLoop(ExecutorHandler(own::execute, threads), DYNAMIC),
        { regions, answers -> PekkoRegions(host ?: own!!.get(), regions, answers) },
        { own?.end() },
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

    override fun close() {
        steps.close()
    }
}
