package daphnis.core.engine.horizon

import daphnis.core.api.EngineApi
import daphnis.core.engine.QuickerWay
import daphnis.core.engine.lists.ListSteps
import daphnis.core.engine.lists.ListTuning
import daphnis.core.parallel.OptionalLoop
import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep

/**
 * Takes steps in epochs, which look ahead over several of them, where that should be quicker, for an engine that takes
 * its other steps in another way. The work is shared among the workers of [loop]: searches and passes by ranges of
 * spheres, collisions by groups of spheres that lie side by side, one for each worker. With few spheres for each worker
 * the caller's thread may take steps alone, where a trial has shown that to be quicker. Steps of dense systems of few
 * spheres are taken on the caller's thread, by neighbour lists that are kept from step to step.
 *
 * ```
 *   if (!horizon.take(step)) {
 *       …                      // in another way
 *       horizon.tookAnother(step)
 *   }
 * ```
 *
 * One thread at a time. After an exception other than an [Error] out of a law the object may be used on.
 *
 * @param fewest the least number of spheres with which epochs are made; 0 makes them wherever lines can be used, and
 *   shares all work among the workers, however little
 * @param tuning how epochs are laid out; null for what should be quickest
 * @param quicker finds out in which way steps are taken soonest; null where all workers share every step in
 *   epochs that the plan expects to be quick
 * @param prospect says whether there is enough to do; null where there is
 */
@EngineApi
public class HorizonSteps internal constructor(
    loop: RangeLoop,
    private val fewest: Int,
    private val tuning: HorizonTuning?,
    filter: LineFilter,
    internal val prepared: PreparedStep,
    lists: ListTuning,
    private val quicker: QuickerWay?,
    private val prospect: Prospect?,
) {
    @JvmOverloads
    public constructor(loop: RangeLoop, fewest: Int = WORTH_SPHERES, tuning: HorizonTuning? = null) :
        this(
            loop,
            fewest,
            tuning,
            LineFilter.BEST,
            PreparedStep(),
            listsFor(loop.workers, fewest, tuning),
            trialFor(fewest, tuning),
            null,
        )

    private val isEager = fewest == 0

    /** The loop by which steps are taken, and what follows them: on the caller's thread while that is quicker. */
    internal val loop = OptionalLoop(if (isEager) FineLoop(loop) else loop)

    private val filters = FilterChoice(filter, always = isEager)
    private val carried = WholePopulation(prepared, this.loop)
    internal val epoch = Epoch(prepared, this.loop, filters, isEager)
    internal val lists = ListSteps(prepared, lists, this.loop)

    /** Steps taken in epochs since the start. */
    public var steps: Long = 0
        private set

    /** Whether the run is so short that the serial engine takes the present step if it is not taken here. */
    internal var isShort = false
        private set

    /** Collisions counted, and epochs begun, before the present step. */
    private var before = 0L
    private var begun = 0L

    /** [quicker], if the present step may be taken in several ways. */
    private var judge: QuickerWay? = null

    /**
     * Takes [step], if that should be quicker here.
     *
     * @param beforeWriting called when all is known and nothing has been written, and now and then before; what it
     *   throws leaves the population as before
     * @return false when it is to be taken in another way; then nothing has changed
     * @throws IllegalArgumentException when the step is refused
     */
    @JvmOverloads
    public fun take(step: CollisionStep, beforeWriting: Runnable = Runnable {}): Boolean {
        before = step.counters.collisions
        begun = epoch.tally.begun
        val size = step.population.size
        prospect?.look(step)
        val isAlone = loop.workers <= 2 && prospect?.isVeryLong == false
        isShort = isAlone || prospect?.isLong == false
        if (!step.law.isPlain) {
            judge = null
            lists.drop()
            epoch.drop()
            return false
        }
        judge = if (prospect?.isLong == false) null else quicker
        val way = judge?.choose(waysOf(step, isAlone))
        loop.isAlone = isAlone || way == ALONE
        if (way == OTHER) {
            lists.drop()
            epoch.drop()
            return false
        }
        if (lists.take(step, beforeWriting)) {
            epoch.drop()
            prospect?.passed(step, step.counters.collisions - before)
            judge?.finish(begins = true, ends = true)
            return true
        }
        filters.passed(size)
        if (size < maxOf(fewest, 1) ||
            prospect?.isLong == false ||
            !(isEager && tuning != null) &&
            epoch.plan.rests()
        ) {
            epoch.drop()
            return false
        }
        val columns = epoch.carry(step, carried.also { it.step = step }, tuning) ?: return false
        beforeWriting.run()
        epoch.finish(carried, columns)
        step.record?.sort()
        epoch.addTo(step.counters)
        steps++
        prospect?.passed(step, step.counters.collisions - before)
        judge?.finish(begins = epoch.tally.begun > begun)
        return true
    }

    /** [step], which [take] has refused, has been taken in another way. */
    public fun tookAnother(step: CollisionStep) {
        if (epoch.collisions.hasFailed) step.counters.causalityReplays++
        val size = step.population.size
        val collisions = step.counters.collisions - before
        if (size > 0) epoch.plan.observe(collisions.toDouble() / size)
        prospect?.passed(step, collisions)
        judge?.finish(begins = true, ends = true)
    }

    /** The ways in which [step] may be taken, by one worker only where it [isAlone]; the first is where to begin. */
    private fun waysOf(step: CollisionStep, isAlone: Boolean): IntArray {
        val own = when {
            loop.workers == 1 || isAlone -> FOR_ONE
            // Giants keep their lines on one thread only.
            step.population.size < SHARED_SPHERES.toLong() * loop.workers || epoch.hasGiants -> FOR_FEW
            else -> FOR_MANY
        }
        // A step that is long for the gas may take the other engine a hundred times as long.
        return if (lists.isOpen || epoch.plan.isFarAhead) own.own else own.withOther
    }

    /** Ways of which the first is where to begin. */
    private class Ways(vararg val own: Int) {
        val withOther = own + OTHER
    }

    /** A loop of small pieces, unless it is to be one. */
    private class FineLoop(private val loop: RangeLoop) : RangeLoop by loop {
        override fun run(size: Int, body: RangeBody) {
            loop.run(size, GRAIN, body)
        }

        override fun run(size: Int, grain: Int, body: RangeBody) {
            loop.run(size, if (grain == RangeLoop.WHOLE) grain else minOf(grain, GRAIN), body)
        }

        override fun runLight(size: Int, body: RangeBody) {
            loop.run(size, GRAIN, body)
        }

        private companion object {
            const val GRAIN = 8
        }
    }

    @EngineApi
    public companion object {
        /** Spheres from which on epochs can pay. */
        public const val WORTH_SPHERES: Int = 256

        /** Spheres for each worker from which on all share the work without a trial. */
        private const val SHARED_SPHERES = 20_000

        /** Where lists are used unless somebody wants epochs. */
        internal fun listsFor(threads: Int, fewest: Int, tuning: HorizonTuning?): ListTuning =
            if (fewest > 0 && tuning == null) ListTuning.best(threads) else ListTuning.NEVER

        // Ways of taking a step: as another engine does, and in epochs or by lists, on one thread or shared.
        internal const val OTHER = 0
        internal const val ALONE = 1
        internal const val SHARED = 2
        private val FOR_ONE = Ways(ALONE)
        private val FOR_FEW = Ways(ALONE, SHARED)
        private val FOR_MANY = Ways(SHARED)

        /** Nanoseconds until each way is tried: in the first two seconds most of an epoch has not been compiled. */
        private val WAITS = longArrayOf(2_000_000_000, QuickerWay.MEASURED, QuickerWay.MEASURED)

        /** What finds out the quickest way, unless somebody wants epochs. */
        internal fun trialFor(fewest: Int, tuning: HorizonTuning?): QuickerWay? =
            if (fewest > 0 && tuning == null) QuickerWay(WAITS) else null
    }
}
