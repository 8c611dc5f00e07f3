package daphnis.core.engine.horizon

import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EndsFinite
import daphnis.core.engine.QuickerWay
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.lists.ListSteps
import daphnis.core.engine.lists.ListTuning
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.parallel.ThreadHandler
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep

/**
 * Looks ahead over several steps at once: it searches for neighbours once in an [Epoch], where the serial engine
 * searches in every step. In a dilute system the search is most of the work. Threads share the search and the passes
 * over all spheres by ranges, and the collisions of a step by groups of spheres that lie side by side.
 *
 * It finds out by trial whether another engine is quicker ([QuickerWay]), and, with few spheres for each thread or with
 * bodies among them, whether several threads are quicker than the caller's alone, with which it begins. Where [CollisionStep.toCome] says that a run is short, the serial engine takes its steps,
 * and two threads are one ([Prospect]).
 *
 * In dense systems of few spheres it keeps neighbour lists from step to step instead, on the caller's thread
 * ([ListSteps]).
 *
 * It takes the same collisions in the same order and fails at the same collision as the serial engine, with the same
 * words. Where lines cannot be used ([EpochFrame.begin]), where a sphere is suddenly too fast for the bounds of the
 * step, and where an epoch would not pay, another engine takes the step. So it is where an epoch would be far more work
 * than that, or turns out to be ([EpochLimits]), whatever the tuning.
 *
 * Where the JVM was started with `--add-modules jdk.incubator.vector`, the search uses the vector unit
 * ([usesVectorUnit]), which is quicker and gives the same bits.
 *
 * @param handler the threads; closed with the engine
 * @param fewest the least number of spheres with which epochs are made; 0 makes them wherever lines can be used, and
 *   shares all work among the threads, however little
 * @param tuning how epochs are laid out; null for what should be quickest
 * @param other takes the other steps, but those of short runs; closed with the engine; null for the serial engine,
 *   which has one thread
 */
public class HorizonEngine internal constructor(
    private val handler: ThreadHandler,
    private val fewest: Int,
    internal val tuning: HorizonTuning?,
    filter: LineFilter,
    lists: ListTuning,
    quicker: QuickerWay?,
    other: CollisionEngine?,
) : CollisionEngine,
    EndsFinite {
    @JvmOverloads
    public constructor(
        handler: ThreadHandler,
        fewest: Int = HorizonSteps.WORTH_SPHERES,
        tuning: HorizonTuning? = null,
        other: CollisionEngine? = null,
    ) :
        this(
            handler,
            fewest,
            tuning,
            LineFilter.BEST,
            HorizonSteps.listsFor(handler.threads, fewest, tuning),
            HorizonSteps.trialFor(fewest, tuning),
            other,
        )

    override val name: String get() = "horizon"
    override val threads: Int get() = handler.threads
    private val gate = ClosableLoop(ParallelLoop(handler, LoopStrategy.DYNAMIC), CollisionEngine.CLOSED)
    override val loop: RangeLoop get() = steps.loop.forOthers

    private val prepared = PreparedStep()
    private val alone = SerialEngine(prepared = prepared)
    private val other = other ?: alone
    private val prospect = if (fewest > 0 && tuning == null) Prospect() else null
    private val steps = HorizonSteps(gate, fewest, tuning, filter, prepared, lists, quicker, prospect)
    private val epoch = steps.epoch

    /** How dense steps of few spheres are taken. */
    internal val lists: ListSteps get() = steps.lists

    /** See [HorizonSteps.isShort]. */
    internal val isShort: Boolean get() = steps.isShort

    /** Epochs begun, and steps taken in them, since the start; all other steps were another engine's. */
    public val epochs: Long get() = epoch.tally.begun
    public val epochSteps: Long get() = steps.steps

    /** Windows begun within a step, apart from the first of each, since the start. */
    internal val windows: Long get() = epoch.tally.windows

    /** What was looked at in the present epoch, or its last window, in the nanoseconds of [EpochCost]. */
    internal val work: Double get() = epoch.collisions.work

    /** Spheres that were found off their lines, at the starts of steps, since the start. */
    internal val strays: Long get() = epoch.tally.strays

    /** Spheres that were too large for cells, at the starts of epochs, since the start. */
    internal val giants: Long get() = epoch.tally.giants

    /** Collisions in which a giant has kept its line, since the start. */
    internal val kept: Long get() = epoch.collisions.whole.pairs.giants.kept

    /** How threads have shared collisions. */
    internal val shared: SharedCollisions get() = epoch.collisions.shared

    /**
     * After a step in an epoch it is so: all spheres have been on lines, which are within the bounds of the frame, or
     * were measured before.
     */
    override var endedFinite: Boolean = false
        private set

    override fun advance(step: CollisionStep) {
        endedFinite = false
        gate.requireOpen()
        val before = epochSteps
        if (steps.take(step)) {
            endedFinite = epochSteps > before
            return
        }
        (if (steps.isShort) alone else other).advance(step)
        steps.tookAnother(step)
    }

    override fun close() {
        gate.close()
        alone.close()
        other.close()
        handler.close()
    }

    public companion object {
        /** Whether searches use the vector unit in this JVM. */
        @JvmStatic
        public val usesVectorUnit: Boolean get() = LineFilter.BEST !== ScalarFilter
    }
}
