package daphnis.actors.region

import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonSteps
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.step.CollisionStep
import java.util.concurrent.Semaphore

/**
 * The common part of the engines on regions: a step from its beginning to its end, and the end of the engine.
 *
 * **Two ways of taking a step.** Where it should be quicker, regions share the loops of a step ([RegionLoop]); else the
 * serial engine takes it on the thread that calls [advance].
 *
 * **How a step ends.** Regions process collisions on paths that are guesses until they have been checked, so an
 * exception out of a region may come from something that never happens. The step is then left to the serial engine,
 * which is the specification: its result, from the population that no thread has written, is the outcome. An [Error] is
 * passed on at once. After either, all regions are replaced by new ones, since the one that failed may have left shared
 * data incomplete.
 *
 * **How the engine ends.** [close] marks and cancels, and never waits, so it may be called from anywhere, even from a
 * function that a region is calling. The last of the step under way and [close] ends the regions and calls [release].
 *
 * @param regions how many are asked for, see [RegionCount]
 * @param threads number of workers to plan for
 * @param inner the loop on the engine's threads
 * @param open starts the regions
 * @param release ends the engine's threads
 */
internal class RegionSteps(
    private val regions: Int,
    private val threads: Int,
    inner: RangeLoop,
    private val open: (List<Region>, Answers) -> RegionHost,
    private val release: () -> Unit,
) : AutoCloseable {
    init {
        RegionCount.requireValid(regions)
    }

    /** The regions, and what takes steps with them. */
    private class Crew(val coordinator: Coordinator, fewest: Int, tuning: HorizonTuning?) {
        val loop = RegionLoop(coordinator)
        val horizon = HorizonSteps(loop, fewest, tuning)
        val serial = SerialEngine(WatchedQueue(loop::requireWanted), horizon.prepared)
    }

    /** Held while a step is under way or the engine is being shut down. */
    private val stepping = Semaphore(1)
    private var crew: Crew? = null

    @Volatile
    private var current: Coordinator? = null

    /** Called by every region, with its number, before each share; for tests. Set before the first step. */
    var probe: ((Int) -> Unit)? = null

    /** The least number of spheres with which steps are taken in epochs. Set before the first step. */
    var fewest: Int = HorizonSteps.WORTH_SPHERES

    /** How epochs are laid out, null for what should be quickest; for tests. Set before the first step. */
    var tuning: HorizonTuning? = null

    /** See [Coordinator]; tests shorten it. Set before the first step. */
    var patience: Long = Coordinator.PATIENCE

    private val gate = ClosableLoop(inner, CLOSED)

    /** The loop on the engine's threads, until it is closed. */
    val loop: RangeLoop get() = gate

    /**
     * Takes [step] on this thread. An interrupt does not end it; the flag is set again afterwards.
     *
     * @param isWanted asked now and then; false cancels the step
     */
    fun advance(step: CollisionStep, isWanted: () -> Boolean = { true }) {
        val crew = enter(step.population.size)
        try {
            crew.loop.beginStep(isWanted)
            try {
                take(crew, step)
            } finally {
                crew.loop.endStep()
            }
        } finally {
            leave(crew)
        }
    }

    private fun take(crew: Crew, step: CollisionStep) {
        try {
            if (crew.horizon.take(step, crew.loop::requireWanted)) return
            crew.serial.advance(step)
            crew.horizon.tookAnother(step)
        } catch (e: Exception) {
            if (e !== crew.coordinator.failure) throw e
            SerialEngine(prepared = crew.horizon.prepared).advance(step)
            step.counters.causalityReplays++
        }
    }

    private fun enter(spheres: Int): Crew {
        gate.requireOpen()
        check(stepping.tryAcquire()) { "a step is under way" }
        try {
            val crew = crew ?: newCrew(spheres).also { crew = it }
            crew.coordinator.begin()
            current = crew.coordinator
            // A [close] which does not see the coordinator yet has set the mark before this line.
            if (gate.isClosed) crew.coordinator.cancel(CLOSED)
            return crew
        } catch (e: Throwable) {
            leave(crew)
            throw e
        }
    }

    private fun newCrew(spheres: Int): Crew {
        val members = List(RegionCount.of(regions, spheres, threads)) { Region(it) }
        for (region in members) probe?.let { region.probe = it }
        val answers = Answers(members.size)
        val host = open(members, answers)
        try {
            return Crew(Coordinator(members, answers, host, patience), fewest, tuning)
        } catch (e: Throwable) {
            host.stop()
            throw e
        }
    }

    private fun leave(crew: Crew?) {
        current = null
        try {
            if (crew != null && !crew.coordinator.isReusable) {
                this.crew = null
                crew.coordinator.stop()
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
            crew?.coordinator?.stop()
            crew = null
            release()
        } catch (e: Throwable) {
            // Out of memory, for example. Closing again tries again.
        } finally {
            stepping.release()
        }
    }

    override fun close() {
        gate.close()
        current?.cancel(CLOSED)
        takeDown()
    }

    private companion object {
        const val CLOSED = "the engine is closed"
    }
}
