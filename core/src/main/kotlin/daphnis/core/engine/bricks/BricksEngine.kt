package daphnis.core.engine.bricks

import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.QuickerWay
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.Way
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.parallel.ThreadHandler
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep

/**
 * Bricks that own their spheres: each thread computes whole steps of parts of space, in memory of its own, with the
 * serial engine's code. It shares nothing with other threads until the step is done. Around its territory a brick has a
 * halo of its neighbours' spheres, which it computes too. At the end neighbours compare the paths that both have
 * computed. Where they differ, the halo was too narrow, and the brick computes the step again with a wider one.
 *
 * ```
 *      territory of A          │          territory of B
 *                     ┌────────┼────────┐
 *    ○   ○    ○   ○   │ ○    ○ │ ●    ● │  ○    ○   ○   ○
 *                     │        │ in sight of A          ●  copies that A computes too
 *      ○    ○   ○     │  ○   ○ │ ●   ●  │   ●    ●  │  ○
 *                     │        │        │  room for │
 *    ○    ○   ○   ○   │○    ○  │  ●   ● │  chains ● │ ○   ○
 *                     └────────┼────────┘
 * ```
 *
 * **Same bits.** Let P(q) be the path of sphere q that its owner has computed. Suppose that, for every brick n at once,
 * n has computed P(q) for all q in its sight, which is everything that a sphere of the territory could touch within the
 * bounds of the step. Then {P} is the serial engine's step. Otherwise take its first collision, p with q, that {P}
 * lacks or has otherwise; up to then the paths of both are right in {P}. If one brick owns both, its own computation
 * would have found the collision. If p's owner n does not own q, then q is in the sight of n, so n has worked with P(q)
 * and would have found it. A collision that only {P} has fails in the same way. "At once" takes one agreement of all
 * bricks: one that computes again may change a path that was compared before. Copies keep the coordinates and images of
 * the whole box, so they are rounded as in the serial engine.
 *
 * So exactness does not rest on the width of the halo, which is a guess; that only decides how often bricks compute
 * again ([HaloMargins]). A guess may end with an exception, though. The step is then left to the serial engine, whose
 * result is the result, and is counted in `causalityReplays`. That happens too when bricks do not come to agree. A step
 * that is given up because it takes too long is not counted: that depends on the machine.
 *
 * Where it should be quicker, and for few spheres, the engine takes steps in the serial engine's way. In dense gases it
 * makes more bricks than there are threads, since the rows of a small brick stay in the cache ([BrickCost]).
 *
 * What a brick does is a state machine, [BrickNode], which knows neither threads nor where the others are.
 *
 * @param handler the threads; closed with the engine
 * @param fewest the least number of spheres with which bricks are made; 0 always makes them
 * @param division how space is divided; null for what should be quickest
 */
public class BricksEngine internal constructor(
    private val handler: ThreadHandler,
    private val fewest: Int,
    division: BrickDivision?,
    margins: HaloMargins,
    private val quicker: QuickerWay,
    ahead: BrickAhead.Choice = BrickAhead.Choice.QUICKEST,
) : CollisionEngine {
    @JvmOverloads
    public constructor(handler: ThreadHandler, fewest: Int = WORTH_SPHERES, division: BrickDivision? = null) :
        this(handler, fewest, division, HaloMargins(), QuickerWay())

    public constructor(threads: Int) : this(FixedPool(threads))

    override val name: String get() = "bricks"
    override val threads: Int get() = handler.threads
    private val gate = ClosableLoop(ParallelLoop(handler, LoopStrategy.DYNAMIC), CollisionEngine.CLOSED)
    override val loop: RangeLoop get() = gate

    private val whole = PreparedStep()
    private val alone = SerialEngine(prepared = whole)
    private val plan = TerritoryPlan(whole, margins, threads, division)
    internal val crew = BrickCrew(whole, margins, ahead = ahead)
    private var failed = false

    /** Attempts that bricks computed again, with wider halos, since the start; without steps that were given up. */
    public val redone: Long get() = crew.redone

    /** Number of spheres in halos in the last step that bricks computed, each as often as it was computed. */
    public val haloSpheres: Int get() = crew.haloSpheres

    /** Number of bricks in the last step; 1 when it was taken in the serial engine's way. */
    public var bricks: Int = 1
        private set

    override fun advance(step: CollisionStep) {
        gate.requireOpen()
        bricks = 1
        if (step.population.size < fewest || plan.rests(step)) {
            alone.advance(step)
        } else if (fewest == 0) {
            if (!divide(step)) goAlone(step)
        } else if (quicker.choose() == Way.SERIAL) {
            alone.advance(step)
            quicker.finish()
        } else if (divide(step)) {
            quicker.finish()
        } else {
            if (plan.territory != null) quicker.giveUp()
            goAlone(step)
        }
    }

    /** The step after bricks were given up. */
    private fun goAlone(step: CollisionStep) {
        alone.advance(step)
        if (failed) step.counters.causalityReplays++
    }

    /** @return false when the step was given up, is not worth it, or has failed; then nothing has changed */
    private fun divide(step: CollisionStep): Boolean {
        failed = false
        try {
            whole.measure(step, loop)
            plan.prepare(loop)
            val territory = plan.territory ?: return false
            if (crew.territory !== territory) crew.settle(territory)
            val total = step.population.size
            val end = crew.compute(total, plan.bodies, plan.extent, loop) { quicker.isLate }
            failed = end == BrickCrew.End.DISAGREED
            if (end != BrickCrew.End.AGREED) return false
            crew.collect(step.record)
            bricks = territory.size
        } catch (e: Exception) {
            if (gate.isClosed) throw e
            failed = true
            return false
        }
        crew.store(loop)
        crew.addTo(step.counters)
        return true
    }

    override fun close() {
        gate.close()
        handler.close()
    }

    private companion object {
        const val WORTH_SPHERES = 20_000
    }
}
