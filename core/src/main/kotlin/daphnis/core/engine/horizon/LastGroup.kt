package daphnis.core.engine.horizon

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.growth.IntList
import daphnis.core.population.PopulationColumns
import daphnis.core.step.CollisionStep

/**
 * Processes on one thread what groups could not decide alone: clusters of spheres that met one another across the
 * borders of groups, from the start of the step. Where one of them comes near a sphere that a group has changed, the
 * cluster of that sphere is dropped too, and all begins anew.
 *
 * @param group the one that does it, which sees all
 * @param isPatient whether it goes on however much work it is
 */
internal class LastGroup(
    private val space: EpochSpace,
    private val groups: List<CollisionGroup>,
    private val group: CollisionGroup,
    private val isPatient: Boolean,
) : CollisionGroup.Others {
    private val frame = space.frame
    private val lines = space.lines

    /** Slots of spheres whose clusters were dropped. */
    private val reopened = IntList()

    /** Pairs of spheres of two groups which touch unless something comes between, and spheres that came near. */
    private val touching = PairList()
    private val doomed = PairList()
    private var isInUse = false

    val hasFailed: Boolean get() = group.hasFailed

    /** Spheres whose clusters were dropped, since the start, and rounds of processing anew. */
    var reopenings = 0L
        private set
    var rounds = 0L
        private set

    /** Collisions processed in this step, in all rounds, and pieces compared with others for them. */
    var processed = 0L
        private set
    var compared = 0L
        private set

    /**
     * @param collisions of all groups in the step so far
     * @return false when the step cannot be ended in this way, or not soon
     */
    fun process(
        collisions: Long,
        step: CollisionStep,
        tracks: Boolean,
        due: List<List<PairList>>,
        meetings: List<PairList>,
    ): Boolean {
        isInUse = false
        begin(tracks)
        reopened.clear()
        group.work.start(parts = 1)
        processed = 0
        compared = 0
        touching.clear()
        doomed.clear()
        for (lists in due) lists[groups.size].forEach { i, j, code -> look(i, j, code) }
        for (list in meetings) list.forEach { i, j, _ -> doomed.add(i, j, 0) }
        for (other in groups) other.crossings.forEach { i, j, _ -> doomed.add(i, j, 0) }
        if (doomed.size == 0) return true
        val most = rounds + MOST_ROUNDS
        do {
            if (++rounds > most || !isPatient && isTooMuch(collisions)) return false
            reopen()
            begin(tracks)
            doomed.clear()
            val isDone = group.processApart { start(step, due) }
            processed += group.impact.counted.collisions
            compared += group.compared
            if (!isDone || lines.isLost) return false
        } while (doomed.size > 0)
        return true
    }

    /** Whether the work so far is more than all of what the groups have done. */
    private fun isTooMuch(collisions: Long): Boolean = processed + compared / COMPARED_A_COLLISION > collisions

    /** Undoes what this group has done, and begins the step. */
    private fun begin(tracks: Boolean) {
        if (isInUse) group.paths.forEachLive { restore(group.held.slotOf(it)) }
        group.begin(tracks, keepsPaths = true)
        group.rest()
    }

    private fun restore(slot: Int) {
        lines.copy(slot, space.before, slot)
    }

    /** A pair of spheres of two groups is due: whether it touches if both keep their lines. */
    private fun look(i: Int, j: Int, code: Int) {
        if (group.pairs.wouldTouch(i, j, code)) {
            touching.add(i, j, code)
            doomed.add(i, j, 0)
        }
    }

    /** Drops the clusters of all that are doomed. */
    private fun reopen() {
        doomed.forEach { i, j, _ ->
            drop(i)
            drop(j)
        }
    }

    private fun drop(slot: Int) {
        if (!haveChanged(slot)) return
        val owner = groups[space.shares.ownerOf(slot)]
        owner.paths.drop(owner.held.presentPlaceOf(slot)) { place ->
            val s = owner.held.slotOf(place)
            restore(s)
            owner.held.forget(place)
            reopened.add(s)
            reopenings++
        }
    }

    /** Whether a group has changed the sphere in [slot], and that holds. */
    override fun haveChanged(slot: Int): Boolean {
        val owner = groups[space.shares.ownerOf(slot)]
        val place = owner.held.presentPlaceOf(slot)
        return place != SlotPlaces.NONE && owner.paths.isLive(place)
    }

    private fun start(step: CollisionStep, due: List<List<PairList>>) {
        isInUse = true
        group.open(if (step.record == null) null else group.record)
        group.others = this
        for (k in 0 until reopened.size) {
            if (group.work.isTooMuch()) return
            val place = group.held.placeOf(reopened[k])
            val piece = group.trails.add(reopened[k], lines, frame.windowStart, isNew = false)
            group.paths.setPiece(place, piece)
            meet(piece)
        }
        touching.forEach { i, j, code -> group.ask(i, j, code) }
        for (lists in due) for (g in groups.indices) lists[g].forEach { i, j, code -> askAgain(i, j, code) }
    }

    /** A pair of a group that is due: whether it is one of this group now. */
    private fun askAgain(i: Int, j: Int, code: Int) {
        if (!group.held.has(i) && !group.held.has(j)) return
        if (!haveChanged(i) && !haveChanged(j)) group.ask(i, j, code)
    }

    /** Compares [piece] with all that groups have kept. */
    override fun meet(piece: Int) {
        for (other in groups) {
            group.meet(piece, other, alsoOld = true, isTwice = false) { q ->
                val slot = other.trails.slots[q]
                doomed.add(slot, slot, 0)
            }
        }
    }

    /** Adds what counts to [counters] and [record]. */
    fun addTo(counters: CollisionCounters, record: CollisionRecord?) {
        if (isInUse) group.paths.addTo(counters, record, group.record)
    }

    /** Writes its rows to [columns], and makes later ones from them where the step [goesOn]. */
    fun store(columns: PopulationColumns, goesOn: Boolean) {
        if (isInUse) {
            group.held.store(columns, frame.duration)
            if (goesOn) group.held.keep()
            group.paths.forEachLive { place ->
                val slot = group.held.slotOf(place)
                space.before.copy(slot, lines, slot)
            }
        }
        isInUse = false
        group.rest()
    }

    private companion object {
        /** Rounds after which the step is left to another engine. */
        const val MOST_ROUNDS = 64

        /** Pieces that are compared in the time of a collision. */
        const val COMPARED_A_COLLISION = 100
    }
}
