package daphnis.core.engine.horizon

import daphnis.core.boundary.imagesApproach
import daphnis.core.collision.CollisionCounters
import daphnis.core.parallel.OptionalLoop
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.step.CollisionStep
import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep

/**
 * Several steps for which the whole population is searched once.
 *
 * Each sphere has a line, along which it is expected to fly ([Lines]). At the start of the epoch every pair of lines
 * that come near each other before its end is filed in a calendar, under the step before which the two cannot touch.
 * From then on a step looks only at the pairs that are due, and at spheres that have got a new line: by a collision, or
 * since something has moved them, which [Passage] notices.
 *
 * ```
 *   start of the epoch:   cells ─▶ lines ─▶ search for all ─▶ calendar
 *   each step:            passage ─▶ search for those off their lines ─▶ pairs due ─▶ collisions ─▶ population
 *                                                                ▲               │
 *                                                                └─ new lines ◀──┘
 * ```
 *
 * **Why no collision is missed.**
 *
 * - (A) Two spheres that can touch before the end of the epoch, as long as both keep their lines, are filed under that
 *   step or an earlier one, or are found when the later of the two lines is drawn: whoever gets a new line searches
 *   among all others.
 * - (B) In every step, each sphere is within the deviation of its line until its first collision. That was seen before
 *   the collisions of the step, and holds for a line drawn at a collision. A giant may follow its line for longer
 *   ([SteadyGiants]): then pairs with it stay filed, and those asked in the step are asked again.
 * - (C) Searches find every line that can come near: a member is near its cell until the end of the epoch, a roamer is
 *   in the list of roamers. A line is checked for that when it is drawn.
 *
 * The radii are inflated by twice the deviation and by the rounding of lines to floats, so by (B) a pair is due no
 * later than it touches. Whether and when a pair that is due touches is decided by [contactTime] alone, from the
 * numbers of the population, or of rows after a collision. So the collisions are those of the serial engine, in the
 * same order and with the same bits; lines, cells and deviation decide only how often is asked in vain.
 *
 * With several threads the searches and the passes are shared by ranges of spheres, the collisions by groups of spheres
 * that lie side by side, see [SharedCollisions].
 *
 * Nothing in an epoch depends on what happened to the step before: a step that was taken back, or a population that was
 * moved by hand, shows by spheres that are not on their lines.
 */
internal class Epoch(
    private val prepared: PreparedStep,
    private val loop: OptionalLoop,
    private val filters: FilterChoice,
    private val isEager: Boolean,
    private val witness: Impact.Witness? = null,
) {
    private val space = EpochSpace(loop)
    private val frame = space.frame
    private val cells = space.cells

    val plan = EpochPlan()
    val collisions = EpochCollisions(prepared, space, loop, plan, isEager, witness)
    private val whole = collisions.whole
    private val searches = EpochSearches(space, collisions.workers, loop)
    private val passage = Passage(space, loop)

    private val sizes = MemberSizes()
    private var filter: LineFilter = ScalarFilter
    private lateinit var tuning: HorizonTuning

    /** Index in the population by slot of the first window. */
    private var firstOrder = IntArray(0)

    /** The same of the present step: index in its spheres by slot; null when the two are the same. */
    var order: IntArray? = null
        private set
    private var spheres = 0

    val tally = EpochTally()

    /** Whether the step after the present one may belong to this epoch. */
    private var isOpen = false

    /** Whether the last epoch that was thought of has spheres without cells since they are so large. */
    val hasGiants: Boolean get() = frame.hasGiants

    /** The next step begins a new epoch. */
    fun drop() {
        collisions.hasFailed = false
        isOpen = false
    }

    /** Whether [step] can be the next one of the present epoch, as far as its spheres are not asked. */
    fun mayGoOn(step: CollisionStep): Boolean =
        isOpen && !collisions.calendars.areFull(spheres) && frame.continues(step, prepared.imagesOf(step))

    /**
     * Carries the spheres of [carried] through [step], and writes them nowhere but to new columns; [finish] follows.
     *
     * @param fixed how epochs are laid out; null for what should be quickest
     * @return the columns; null when the step is to be taken in another way; then nothing has changed
     * @throws IllegalArgumentException when the step is refused
     */
    fun carry(step: CollisionStep, carried: Carried, fixed: HorizonTuning?): PopulationColumns? {
        // Lines know of images that slide along rows alone, and of walls that know their way for several steps.
        if (step.boundary.imagesApproach || !step.boundary.walls.areKnownAhead) {
            drop()
            return null
        }
        val mayGoOn = mayGoOn(step) && carried.follow(spheres)
        val wasOpen = isOpen
        isOpen = false
        collisions.hasFailed = false
        space.limits.isExceeded = false
        frame.step++
        val tracks = step.law.guard.needsLastCollision
        var columns = if (mayGoOn) goOn(carried, tracks) else null
        val goesOn = columns != null
        if (columns == null) {
            if (!mayGoOn) carried.measure(along = null)
            prepared.prepareWithoutGrid()
            if (wasOpen) tally.end(plan, frame.step, spheres, searches.listed, isBroken = mayGoOn)
            // Those that are away have no place in a new epoch.
            if (mayGoOn && carried.visits != null || !layOut(step, carried.spheres, fixed)) return null
            columns = carried.columnsToWrite(tracks, keepsOrder = false)
            begin(carried, columns)
        }
        order = if (goesOn) null else cells.order
        passage.keep(carried.spheres, columns, order, tracks)
        val isDone = if (frame.windows > 1) {
            takeWindows(step, carried, columns, tracks)
        } else {
            if (goesOn) searchChanged(carried) else searchAll()
            takeStep(step, carried, columns, tracks)
        }
        if (isDone) return columns
        if (space.limits.isExceeded) plan.abandoned((tally.listed + searches.listed) / (spheres * (frame.step + 1.0)))
        return null
    }

    /** The step stands: what [carry] has written to [columns] is what [carried] has now. */
    fun finish(carried: Carried, columns: PopulationColumns) {
        carried.take(columns)
        isOpen = true
    }

    /** Adds what the step has counted to [counters]. */
    fun addTo(counters: CollisionCounters) {
        val before = counters.collisions
        collisions.addTo(counters)
        tally.collisions += counters.collisions - before
    }

    /** Measures the next step of the epoch and writes where spheres fly. @return null when there is none */
    private fun goOn(carried: Carried, tracks: Boolean): PopulationColumns? {
        val visits = carried.visits
        if (visits != null) {
            spheres = carried.spheres.size
            space.admit(carried.spheres, spheres, visits, whole.newLines)
            collisions.reserve(spheres)
        }
        val columns = carried.columnsToWrite(tracks, keepsOrder = true)
        carried.measure(passage.next(carried.spheres, columns))
        if (passage.hasNext()) {
            prepared.prepareWithoutGrid()
            return columns
        }
        carried.giveBack(columns)
        return null
    }

    /** @return whether there can be an epoch of [all] from [step] on, and it should be quicker than the serial engine */
    private fun layOut(step: CollisionStep, all: SphereColumns, fixed: HorizonTuning?): Boolean {
        frame.takeOver(step, all, prepared.reach, loop)
        cells.speeds.measure(all)
        frame.memberRadius = sizes.choose(all, frame, cells.speeds.rms, loop)
        filter = filters.choose(all.size)
        tuning = plan.layOut(fixed, all.size, space, filter, loop.active, isEager) ?: return false
        cells.sort(all, tuning, 0.0)
        return true
    }

    private fun begin(carried: Carried, columns: PopulationColumns) {
        frame.step = 0
        searches.begin()
        tally.begin()
        spheres = carried.spheres.size
        space.open(carried.visits)
        collisions.reserve(spheres)
        passage.first(carried.spheres, cells, columns)
        beginWindow()
    }

    /** All lines have been drawn anew. */
    private fun beginWindow() {
        space.settle(spheres)
        space.roamers.begin(spheres, cells.speeds.fastest, frame.memberRadius)
        space.giants.begin(spheres, cells.speeds.fastest, frame.largestRadius)
        collisions.beginLines(filter)
    }

    private fun searchAll() {
        searches.all()
        plan.searched(searches.tested.toDouble() / spheres)
        tally.giants += space.giants.size
    }

    private fun searchChanged(carried: Carried) {
        val off = passage.changed.size - (carried.visits?.entered?.size ?: 0)
        tally.addStrays(off)
        searches.changed(carried.spheres, passage, whole)
    }

    /** @return false when the step cannot be ended in this way */
    private fun takeStep(step: CollisionStep, carried: Carried, columns: PopulationColumns, tracks: Boolean): Boolean {
        collisions.begin(step, carried, order, tracks)
        return takeWindow(columns, 0)
    }

    /** The same for a step that is taken in several windows. */
    private fun takeWindows(
        step: CollisionStep,
        carried: Carried,
        columns: PopulationColumns,
        tracks: Boolean,
    ): Boolean {
        if (firstOrder.size < spheres) firstOrder = IntArray(cells.order.size)
        cells.order.copyInto(firstOrder, 0, 0, spheres)
        order = firstOrder
        collisions.begin(step, carried, firstOrder, tracks)
        val written = if (columns.size == spheres) columns else FirstOf(columns, spheres)
        for (window in 0 until frame.windows) {
            if (window > 0) openWindow(window, written)
            searchAll()
            if (!takeWindow(columns, window)) return false
        }
        return true
    }

    private fun takeWindow(columns: PopulationColumns, window: Int): Boolean {
        if (space.isOver || !collisions.process(window) || space.isOver) return false
        collisions.store(columns, window)
        return true
    }

    /** Begins a [window] after the first, with spheres as they are in [written] now. */
    private fun openWindow(window: Int, written: SphereColumns) {
        // Entries of roamers that searches have looked at are counted by window.
        tally.listed += searches.listed
        frame.openWindow(window)
        cells.sort(written, tuning, frame.duration)
        cells.invert(spheres)
        collisions.goOn(cells.order, cells.slots)
        passage.again(written, cells)
        beginWindow()
        tally.windows++
    }
}
