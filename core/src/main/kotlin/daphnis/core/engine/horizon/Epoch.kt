package daphnis.core.engine.horizon

import daphnis.core.collision.StepRows
import daphnis.core.collision.contactTime
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.step.CollisionStep
import daphnis.core.step.Impact.End
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
 *   the collisions of the step, and holds for a line drawn at a collision.
 * - (C) Searches find every line that can come near: a member is near its cell until the end of the epoch, a roamer is
 *   in the list of roamers. A line is checked for that when it is drawn.
 *
 * The radii are inflated by twice the deviation and by the rounding of lines to floats, so by (B) a pair is due no
 * later than it touches. Whether and when a pair that is due touches is decided by [contactTime] alone, from rows with
 * the numbers of the population. So the collisions are those of the serial engine, in the same order and with the same
 * bits; lines, cells and deviation decide only how often is asked in vain.
 *
 * Nothing in an epoch depends on what happened to the step before: a step that was taken back, or a population that was
 * moved by hand, shows by spheres that are not on their lines.
 */
internal class Epoch(
    private val prepared: PreparedStep,
    private val loop: RangeLoop,
    private val filters: FilterChoice,
) : EpochImpact.Course {
    private val frame = EpochFrame()
    private val lines = Lines(frame)
    private val cells = EpochCells(frame, lines, loop)
    private val roamers = Roamers(frame, lines)

    /** By worker. The first is also for what is on one thread. */
    private val calendars = List(loop.workers) { PairCalendar(lines) }
    private val searches = calendars.map { LineSearch(frame, lines, cells, roamers, Filer(it)) }
    private val calendar = calendars[0]
    private val search = searches[0]
    private val passage = Passage(frame, lines, loop)
    private val bodies = EpochBodies()
    private val impact = EpochImpact(prepared, bodies, this)

    private val plan = EpochPlan(loop.workers)
    private var filter: LineFilter = ScalarFilter

    /** Number of the present step, from 0. */
    private var index = 0
    private var spheres = 0

    /** Collisions, and spheres found off their lines, in this epoch. */
    private var collisions = 0L
    private var strayed = 0L

    /** Whether the step after the present one may belong to this epoch. */
    private var isOpen = false

    /** Whether collisions are under way: pairs that are due are asked at once. */
    private var isUnderWay = false

    /** Epochs begun since the start. */
    var begun = 0L
        private set

    /** Spheres that were found off their lines since the start. */
    var strays = 0L
        private set

    /** The next step begins a new epoch. */
    fun drop() {
        isOpen = false
    }

    /** Whether the next step should be taken in another way, as the plan has it. */
    fun rests(): Boolean = plan.rests()

    /** Told that a step taken in another way had so many [collisions] per sphere. */
    fun observe(collisions: Double) {
        plan.observe(collisions)
    }

    /**
     * Carries the population through [step], which has been measured.
     *
     * @param fixed how epochs are laid out; null for what should be quickest
     * @return false when the step is to be taken in another way; then nothing has changed
     */
    fun carry(step: CollisionStep, fixed: HorizonTuning?): Boolean {
        prepared.prepareWithoutGrid()
        val wasOpen = isOpen
        isOpen = false
        isUnderWay = false
        val population = step.population
        index++
        var goesOn = wasOpen &&
            spheres == population.size &&
            calendars.sumOf { it.size.toLong() } <= MOST_ENTRIES * spheres + FEW_ENTRIES &&
            frame.continues(step, index, prepared.images)
        if (wasOpen && !goesOn) ended(isBroken = false)
        if (!goesOn && !layOut(step, fixed)) return false
        val tracks = step.law.guard.needsLastCollision
        val columns = population.columnsToWrite(tracks)
        if (goesOn && !passage.next(population, columns, index)) {
            goesOn = false
            ended(isBroken = true)
            if (!layOut(step, fixed)) return false
        }
        if (!goesOn) begin(population, columns)
        val order = if (goesOn) null else cells.order
        bodies.begin(population, order, frame.duration, tracks)
        if (goesOn) searchChanged(population) else searchAll()
        if (!collide(step) || lines.isLost) return false
        if (tracks) age(population, columns, order)
        bodies.store(columns, frame.duration)
        population.take(columns)
        step.record?.sort()
        step.counters.add(impact.counted)
        collisions += impact.counted.collisions
        isOpen = true
        return true
    }

    /** @return whether there can be an epoch from [step] on, and it should be quicker than the serial engine */
    private fun layOut(step: CollisionStep, fixed: HorizonTuning?): Boolean {
        frame.takeOver(step, prepared.reach)
        cells.measure(step.population)
        filter = filters.choose(step.population.size)
        val tuning = fixed ?: plan.choose(step.population.size, frame, cells, filter) ?: return false
        if (!frame.begin(tuning)) return false
        cells.sort(step.population, tuning)
        return true
    }

    private fun begin(population: Population, columns: PopulationColumns) {
        index = 0
        begun++
        collisions = 0
        strayed = 0
        spheres = population.size
        for (calendar in calendars) calendar.begin(frame.steps)
        passage.first(population, cells, columns)
        roamers.begin(spheres, cells.fastest)
        for (search in searches) search.begin(filter)
    }

    /** The epoch ends before step [index]. */
    private fun ended(isBroken: Boolean) {
        val sphereSteps = spheres.toDouble() * index
        plan.ended(index, collisions / sphereSteps, strayed / sphereSteps, isBroken)
    }

    private fun searchAll() {
        loop.run(search.rows, ROWS_A_PIECE) { worker, from, to -> searches[worker].aheadOfRows(from, to) }
        plan.searched(searches.sumOf { it.tested }.toDouble() / spheres)
        // Each sees the roamers before it.
        for (slot in cells.members until spheres) {
            search.around(slot, 0.0, NOBODY)
            roamers.add(slot)
        }
    }

    private fun searchChanged(population: Population) {
        val t = index * frame.duration
        strays += passage.changed
        strayed += passage.changed
        for (k in 0 until passage.changed) {
            val slot = passage.slots[k]
            val p = population
            lines.put(slot, p.x[slot], p.y[slot], p.z[slot], p.vx[slot], p.vy[slot], p.vz[slot], t)
            settle(slot, t)
        }
        if (lines.isLost) return
        for (k in 0 until passage.changed) search.around(passage.slots[k], t, NOBODY)
    }

    /** The line in [slot] is new from time [from] on. */
    private fun settle(slot: Int, from: Double) {
        lines.version[slot]++
        if (lines.isLost) return
        if (cells.hasCell(slot)) {
            lines.moveBack(slot, cells.imageAtCell(slot))
            if (cells.holds(slot, from)) return
        }
        lines.moveBack(slot, cells.imageInBox(slot))
        roamers.add(slot)
    }

    /** @return false when the step cannot be ended in this way */
    private fun collide(step: CollisionStep): Boolean {
        if (lines.isLost) return false
        impact.begin(step.record)
        isUnderWay = true
        for (calendar in calendars) calendar.forEachDue(index) { i, j, code -> ask(i, j, code) }
        val queue = bodies.queue
        while (queue.pop()) {
            if (impact.process(queue.time, queue.first, queue.second, queue.image) != End.DONE) return false
        }
        return true
    }

    /** Files what a worker finds. */
    private inner class Filer(private val calendar: PairCalendar) : LineSearch.Found {
        override fun pair(slot: Int, other: Int, code: Int, from: Double) {
            file(calendar, slot, other, code, from)
        }
    }

    private fun file(calendar: PairCalendar, slot: Int, other: Int, code: Int, from: Double) {
        val touch = lines.touch(slot, other, code, from)
        if (touch > frame.end) return
        val due = frame.stepAt(touch)
        if (due > index || !isUnderWay) {
            if (due < frame.steps) calendar.file(maxOf(due, index), slot, other, code)
        } else {
            ask(slot, other, code)
        }
    }

    /** Finds out whether two spheres touch in the present step; if not, files them under a later one. */
    private fun ask(i: Int, j: Int, code: Int) {
        val first = bodies.placeOf(i)
        val second = bodies.placeOf(j)
        val image = lines.spheresImage(code, i, j)
        val time = contactTime(bodies.rows, first, second, image, prepared.images)
        if (time <= frame.duration) {
            bodies.queue.add(time, first, second, image)
            return
        }
        val next = index + 1
        if (next == frame.steps) return
        val touch = lines.touch(i, j, code, next * frame.duration)
        if (touch > frame.end) return
        val due = maxOf(frame.stepAt(touch), next)
        if (due < frame.steps) calendar.file(due, i, j, code)
    }

    override fun bend(slot: Int, place: Int) {
        val state = bodies.rows.state
        val p = place * StepRows.STRIDE
        val v = p + StepRows.VX
        val t = index * frame.duration + state[p + StepRows.TIME]
        lines.put(slot, state[p], state[p + 1], state[p + 2], state[v], state[v + 1], state[v + 2], t)
        settle(slot, t)
    }

    override fun lookOut(slot: Int, place: Int, except: Int): Boolean {
        if (lines.isLost) return false
        val local = bodies.rows.state[place * StepRows.STRIDE + StepRows.TIME]
        search.around(slot, index * frame.duration + local, except)
        return true
    }

    /** Times since the last collisions of spheres that do not collide in this step. */
    private fun age(population: Population, columns: PopulationColumns, order: IntArray?) {
        val from = population.lastCollision
        val to = columns.lastCollision
        for (k in 0 until population.size) to[k] = from[if (order == null) k else order[k]] - frame.duration
    }

    private companion object {
        const val NOBODY = -1

        /** Rows of cells that a worker takes at a time. */
        const val ROWS_A_PIECE = 16

        /** Entries of the calendar per sphere, and some more, with which an epoch ends: they take memory. */
        const val MOST_ENTRIES = 16L
        const val FEW_ENTRIES = 4096
    }
}
