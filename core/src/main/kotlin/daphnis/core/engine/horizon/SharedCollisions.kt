package daphnis.core.engine.horizon

import daphnis.core.collision.CollisionCounters
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.PopulationColumns
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import daphnis.core.step.StepLimits

/**
 * The collisions of a step, shared among groups of spheres that lie side by side ([Shares]). Each group processes those
 * between its own spheres, in order of time, as if there were no others. Then it is seen where spheres of two groups
 * came so near each other that one group alone could not know: their clusters are dropped, and one thread processes
 * them anew ([LastGroup]).
 *
 * ```
 *   all groups: pairs due ─▶ collisions ─▶ pieces of paths near others ─┐
 *   one thread:                              clusters that met others ◀─┘ ─▶ processed anew
 *   all groups: rows ─▶ population
 * ```
 *
 * **Why the result is that of one thread.** A group is right about a sphere as long as no path of another group's comes
 * near its path in this step, whether before or after a collision. For two spheres that neither collides it is known
 * from the calendar; for one that does it searches among the others' lines at the start of the step ([Sight]), and a
 * pair of two groups that may touch in this step is a crossing. Two spheres of different groups which both collide have
 * both searched, so that each met the other's cell, unless one is a roamer: their pieces are open, and open pieces are
 * compared with all pieces of the other groups. All of this is as conservative as lines are. What the last group does
 * is compared with all pieces that are kept.
 */
internal class SharedCollisions(
    private val prepared: PreparedStep,
    private val space: EpochSpace,
    private val calendars: List<PairCalendar>,
    private val groups: List<CollisionGroup>,
    private val places: SlotPlaces,
    last: CollisionGroup,
    private val loop: RangeLoop,
    isPatient: Boolean,
) {
    private val frame = space.frame
    private val due = List(groups.size) { List(groups.size + 1) { PairList() } }
    private val meetings = groups.map { PairList() }
    private val last = LastGroup(space, groups, last, isPatient)
    private val counted = CollisionCounters()

    /** Steps that groups have ended since the start. */
    var steps = 0L
        private set

    /** Spheres whose collisions were processed anew, since the start, and in how many rounds. */
    val reopened: Long get() = last.reopenings
    val rounds: Long get() = last.rounds

    /**
     * What the last attempt took: collisions of the groups, those processed anew, and pieces compared for these. The
     * first is 0, and the others mean nothing, where it did not come so far.
     */
    var collisions = 0L
        private set
    val processedAnew: Long get() = last.processed
    val compared: Long get() = last.compared

    /** Whether a law, or a limit, ended the last attempt. */
    var hasFailed = false
        private set

    /** Divides the spheres of an epoch among the groups. */
    fun divide(spheres: Int) {
        space.shares.divide(groups.size, space.cells, spheres, loop)
        places.reserve(spheres)
    }

    /** Whether the collisions of the present step are worth the barriers. */
    fun isWorthIt(): Boolean = calendars.sumOf { it.count(frame.step) } >= LEAST_DUE * groups.size

    /**
     * @param isFirst whether this is the first window of [step], or the only one
     * @return false when the step is to be taken in another way; then nothing has changed but lines
     */
    fun process(step: CollisionStep, tracks: Boolean, isFirst: Boolean): Boolean {
        hasFailed = false
        each { prepareGroup(it, tracks) }
        each { processGroup(it, step) }
        collisions = 0
        hasFailed = groups.any { it.hasFailed }
        if (hasFailed || lines.isLost || !isDone.all { it }) return false
        collisions = groups.sumOf { it.impact.counted.collisions }
        each { compare(it) }
        if (space.limits.isExceeded) return false
        val before = if (isFirst) 0L else counted.collisions
        if (!last.process(before + collisions, step, tracks, due, meetings)) {
            hasFailed = last.hasFailed
            return false
        }
        count(step, isFirst)
        hasFailed = counted.collisions + counted.wallCollisions > StepLimits.mostCollisions(step.population.size)
        return !hasFailed && !lines.isLost
    }

    private val lines = space.lines
    private val isDone = BooleanArray(groups.size)

    private fun each(phase: (group: Int) -> Unit) {
        loop.run(groups.size, 1) { _, from, to -> for (g in from until to) phase(g) }
    }

    /** Deals out the pairs that are due in the calendar of group [g]. */
    private fun prepareGroup(g: Int, tracks: Boolean) {
        groups[g].begin(tracks, keepsPaths = true)
        groups[g].work.start(groups.size)
        groups[g].sight.narrow(g)
        val lists = due[g]
        for (list in lists) list.clear()
        val shares = space.shares
        calendars[g].forEachDue(frame.step) { i, j, code ->
            val owner = shares.ownerOf(i)
            lists[if (shares.ownerOf(j) == owner) owner else groups.size].add(i, j, code)
        }
    }

    private fun processGroup(g: Int, step: CollisionStep) {
        val group = groups[g]
        isDone[g] = group.processApart {
            group.open(if (step.record == null) null else group.record)
            for (lists in due) lists[g].forEach { i, j, code -> group.ask(i, j, code) }
        }
        group.trails.sort(groups.size)
    }

    /** Notes which pieces of group [g] meet pieces of others, and files those that come near them after the step. */
    private fun compare(g: Int) {
        val meetings = meetings[g]
        meetings.clear()
        val own = groups[g]
        val trails = own.trails
        for (piece in 0 until trails.size) {
            if (!trails.isOpen(piece)) continue
            if (own.work.isTooMuch()) return
            for (other in groups) {
                if (other !== own) {
                    own.meet(piece, other, alsoOld = false, isTwice = g > other.trails.group) { q ->
                        meetings.add(trails.slots[piece], other.trails.slots[q], 0)
                    }
                }
            }
        }
    }

    private fun count(step: CollisionStep, isFirst: Boolean) {
        if (isFirst) {
            counted.clear()
            step.record?.clear()
        }
        for (group in groups) group.paths.addTo(counted, step.record, group.record)
        last.addTo(counted, step.record)
    }

    /** What the collisions of the step have counted. */
    fun addTo(counters: CollisionCounters) {
        counters.add(counted)
    }

    /**
     * Writes the spheres with rows to [columns]. Others see their lines from now on, and where the step [goesOn] in
     * another window, rows there are made from these.
     */
    fun store(columns: PopulationColumns, goesOn: Boolean) {
        each { g ->
            groups[g].held.store(columns, frame.duration)
            groups[g].paths.forEachLive { place -> settle(groups[g].held.slotOf(place)) }
        }
        for (group in groups) group.newRoamers.forEachPresent(lines) { space.addRoamer(it, isFinal = true) }
        if (goesOn) for (group in groups) group.held.keep()
        // Rows that were dropped are among its rows.
        last.store(columns, goesOn)
        for (group in groups) group.rest()
        if (!goesOn) steps++
    }

    private fun settle(slot: Int) {
        space.before.copy(slot, lines, slot)
    }

    private companion object {
        /** Pairs due, per group, which are worth more than the barriers. */
        const val LEAST_DUE = 100
    }
}
