package daphnis.core.cluster.bricks

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.engine.horizon.Carried
import daphnis.core.engine.horizon.Epoch
import daphnis.core.engine.horizon.FilterChoice
import daphnis.core.engine.horizon.HorizonSteps
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.engine.horizon.LineFilter
import daphnis.core.engine.horizon.Visits
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.OptionalLoop
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity
import daphnis.core.population.SphereQuantity.Change.NOTED
import daphnis.core.population.optional
import daphnis.core.search.StepBounds
import daphnis.core.step.PreparedStep

/**
 * Takes the steps of a brick in epochs, which look ahead over several of them. While one lasts, spheres of the halo come
 * and go, and are known by their ids. One that comes is as one that has left its line: it gets a new one, without a cell,
 * and is searched for. One that goes keeps its place, and nobody meets it.
 *
 * A step that is computed a second time, with a wider halo, is none of an epoch, and ends it.
 *
 * @param collisions takes those that count
 */
internal class BrickAhead(
    private val choice: Choice,
    private val prepared: PreparedStep,
    private val brick: BrickSpheres,
    paths: OwnPaths,
    private val collisions: CollisionRecord,
) : Carried {
    /**
     * When steps are taken in epochs.
     *
     * @property fewest the least number of spheres
     * @property tuning how epochs are laid out; null for what should be quickest
     */
    class Choice(val fewest: Int, val tuning: HorizonTuning?) {
        companion object {
            val QUICKEST = Choice(HorizonSteps.WORTH_SPHERES, null)
            val NEVER = Choice(Int.MAX_VALUE, null)
        }
    }

    private val filters = FilterChoice(LineFilter.BEST, always = false)
    private val epoch = Epoch(prepared, OptionalLoop(InlineLoop), filters, isEager = choice.fewest == 0, paths)
    private lateinit var whole: PreparedStep
    private lateinit var middle: DoubleArray
    private var columns: PopulationColumns? = null
    private val runs = IndexRuns()

    /** What was counted in the last step. */
    val counted = CollisionCounters()

    /** Steps that were taken in epochs, since the start. */
    var steps = 0L
        private set

    /** @return false when the step is to be taken in another way */
    fun solve(whole: PreparedStep, middle: DoubleArray, gather: Gathering): Boolean {
        this.whole = whole
        this.middle = middle
        finish()
        val step = whole.step
        filters.passed(gather.count)
        val rests = gather.count < maxOf(choice.fewest, 1) || choice.tuning == null && epoch.plan.rests()
        if (!rests && brick.isSettled && epoch.mayGoOn(step)) {
            brick.goOn()
            gather.into(brick)
            brick.settle()
            if (!brick.areTooMany && carry()) return true
        }
        gather.anew(brick)
        return !rests && carry()
    }

    private fun carry(): Boolean {
        columns = epoch.carry(whole.step, this, choice.tuning) ?: return false
        counted.clear()
        epoch.addTo(counted)
        steps++
        return true
    }

    /** The step before stands. */
    private fun finish() {
        val columns = columns ?: return
        this.columns = null
        epoch.finish(this, columns)
    }

    /** The next step begins a new epoch. */
    fun drop() {
        columns = null
        epoch.drop()
    }

    /** A step that was taken in another way has [counted] so much. */
    fun observe(counted: CollisionCounters) {
        if (brick.own > 0) epoch.plan.observe(counted.collisions.toDouble() / brick.own)
    }

    /** Writes the brick's spheres to entries [at] and following of [to]. @return how many */
    fun store(to: PopulationColumns, at: Int): Int {
        val from = checkNotNull(columns)
        val order = epoch.order
        runs.clear()
        for (slot in 0 until brick.size) if (brick.isOwn(order?.get(slot) ?: slot)) runs.add(slot)
        val tracks = prepared.step.law.guard.needsLastCollision
        for (place in SphereQuantity.present(brick.optional)) {
            if (!tracks && SphereQuantity.at(place).change == NOTED) continue
            copy(from.column(place), to.column(place), at)
        }
        var k = at
        for (run in 0 until runs.runs) {
            from.id.copyInto(to.id, k, runs.from(run), runs.to(run))
            k += runs.to(run) - runs.from(run)
        }
        return k - at
    }

    private fun copy(from: DoubleArray, to: DoubleArray, at: Int) {
        var k = at
        for (run in 0 until runs.runs) {
            from.copyInto(to, k, runs.from(run), runs.to(run))
            k += runs.to(run) - runs.from(run)
        }
    }

    override val spheres: SphereColumns get() = brick
    override val visits: Visits get() = brick
    override val record: CollisionRecord? get() = if (whole.step.record == null) null else collisions

    /** While places are kept, the first are those of the spheres before. */
    override fun follow(count: Int): Boolean = brick.keepsPlaces

    override fun measure(along: StepBounds.AlongPieces?) {
        prepared.takePart(whole, brick, middle)
        along?.look(0, 0, brick.size)
    }

    override fun columnsToWrite(tracksLastCollision: Boolean, keepsOrder: Boolean): PopulationColumns =
        brick.sets.toWrite(brick.id.size, keepsOrder, tracksLastCollision)

    override fun giveBack(columns: PopulationColumns): Unit = brick.sets.giveBack(columns)

    override fun take(columns: PopulationColumns): Unit = brick.sets.take(columns)
}
