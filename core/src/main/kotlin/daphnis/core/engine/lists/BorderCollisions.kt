package daphnis.core.engine.lists

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.engine.shares.PairList
import daphnis.core.engine.shares.SlotPlaces
import daphnis.core.growth.GrowingTable
import daphnis.core.growth.IntList
import kotlin.math.max

/**
 * Ends a window in which regions have worked: it takes the collisions of spheres of two regions, and all that follow
 * from them, in order of time, from where regions have left these spheres, and sees all.
 *
 * It comes too late where a sphere may touch another before something that has happened to that one in its region. Then
 * what that one has done, and all that it has met, is taken back to the start of the window, and all begins anew.
 *
 * @param regionPlaces see [ListPaths], of the [regions]
 */
internal class BorderCollisions(
    private val field: ListField,
    private val regions: List<ListRegion>,
    private val regionPlaces: SlotPlaces,
) {
    private val lists = field.lists

    /** The spheres that are followed here. */
    private class Taken : GrowingTable() {
        var slots = IntArray(0)
            private set

        /** From when on, whether it had left its shell then, and whether it is followed from the start of the window. */
        var from = DoubleArray(0)
            private set
        var wasOut = BooleanArray(0)
            private set
        var isDropped = BooleanArray(0)
            private set

        /** Whether it is to be followed anew. */
        var isActive = BooleanArray(0)
            private set

        override fun resize(room: Int) {
            slots = slots.copyOf(room)
            from = from.copyOf(room)
            wasOut = wasOut.copyOf(room)
            isDropped = isDropped.copyOf(room)
            isActive = isActive.copyOf(room)
        }

        fun add(slot: Int, at: Double, isOut: Boolean): Int {
            val place = append()
            slots[place] = slot
            from[place] = at
            wasOut[place] = isOut
            isDropped[place] = false
            isActive[place] = false
            return place
        }
    }

    private val taken = Taken()
    private val takenPlaces = SlotPlaces()

    /** Each of them as its region has left it, by place in [taken]. */
    private val given = StepRows()
    private val ownPlaces = SlotPlaces()

    /** Those that are to be followed from where they were taken over, by slot; and pairs of which one is too far ahead. */
    private val active = IntList()
    private val clashes = PairList()
    private var mark = 0
    private var start = 0.0
    private var end = 0.0
    private var isRecorded = false
    private var hasAll = false

    private val region = object : ListRegion(field, ownPlaces) {
        override fun mayMeet(i: Int, j: Int): Boolean {
            followFrom(i, table.time(i))
            if (j >= 0) followFrom(j, table.time(i))
            return true
        }
    }

    /** Collisions processed here in this window, in all rounds, and rounds since the start. */
    var processed = 0L
        private set
    var rounds = 0L
        private set

    /** Makes room for as many spheres as there are, and forgets what there was, also of a step that failed. */
    fun reserve() {
        region.paths.begin()
        for (place in 0 until taken.size) takenPlaces.forget(taken.slots[place])
        taken.clear()
        ownPlaces.reserve(field.size)
        takenPlaces.reserve(field.size)
        region.events.reserve()
        region.sight.see(0, field.size)
    }

    /** Begins a step, see [ListRegion.begin]. */
    fun begin(duration: Double, fastest: Double) {
        region.begin(duration, fastest, expected = 0)
    }

    private fun regionOf(slot: Int) = regions[field.regionOf(slot)]

    private fun hasChanged(slot: Int) = regionPlaces.of(slot) != SlotPlaces.NONE

    /** Whether the sphere in [slot] has changed in its region, and that holds. */
    private fun isAhead(slot: Int): Boolean {
        val place = regionPlaces.of(slot)
        return place != SlotPlaces.NONE && regionOf(slot).paths.clusters.isLive(place)
    }

    /** Takes over the sphere in [slot] as it is, to follow it from time [at] on. @return its place */
    private fun take(slot: Int, at: Double): Int {
        val place = takenPlaces.of(slot)
        if (place != SlotPlaces.NONE) return place
        regionOf(slot).calendar.remove(slot)
        given.take(field.rows, slot)
        takenPlaces.put(slot, taken.size)
        return taken.add(slot, at, field.events.isOut(slot))
    }

    /** The sphere in [slot] is followed from time [at] on, if not before. */
    private fun followFrom(slot: Int, at: Double) {
        val place = take(slot, at)
        if (at < taken.from[place]) taken.from[place] = at
    }

    /** Takes back what the sphere in [slot], and all that it has met, have done here and in their region. */
    private fun drop(slot: Int) {
        if (isAhead(slot)) {
            regionOf(slot).paths.drop(slot, isFinal = false) { takeFromStart(it) }
        } else {
            takeFromStart(slot)
        }
    }

    private fun takeFromStart(slot: Int) {
        val place = take(slot, start)
        if (taken.isDropped[place]) return
        giveBack(slot)
        taken.isDropped[place] = true
        taken.from[place] = start
        field.restore(slot)
        activate(slot)
    }

    private fun activate(slot: Int) {
        if (!taken.isActive[takenPlaces.of(slot)]) {
            taken.isActive[takenPlaces.of(slot)] = true
            active.add(slot)
        }
    }

    /** Takes back what the sphere in [slot], and all that it has met, have done here. */
    private fun giveBack(slot: Int) {
        if (!region.paths.isLive(slot)) return
        region.paths.drop(slot, isFinal = true) {
            val place = takenPlaces.of(it)
            if (taken.isDropped[place]) {
                field.restore(it)
            } else {
                field.rows.put(it, given, place)
                field.events.bend(it)
                field.events.setOut(it, taken.wasOut[place])
            }
            activate(it)
        }
    }

    /** Takes over all that has happened in the window, or might until its end, to follow it from its start on. */
    private fun dropAll() {
        hasAll = true
        for (place in 0 until taken.size) giveBack(taken.slots[place])
        for (r in regions) {
            for (place in 0 until r.paths.changed.size) drop(r.paths.changed[place])
            for (slot in r.sight.first until r.sight.end) {
                if (field.events.place(slot) != SphereCalendar.NONE && field.events.time(slot) <= end) take(slot, start)
            }
        }
        for (place in 0 until taken.size) {
            taken.from[place] = start
            taken.isDropped[place] = true
            // Also one that a law has seen and thrown at.
            field.restore(taken.slots[place])
            activate(taken.slots[place])
        }
        open()
    }

    private fun open() {
        region.open(start, if (isRecorded) region.record else null)
    }

    /**
     * Ends the window from [start] to [end] of a step of [duration].
     *
     * @param isRecorded whether the collisions are wanted
     * @return false when the step cannot be ended in this way
     */
    fun join(start: Double, end: Double, duration: Double, isRecorded: Boolean): Boolean {
        this.start = start
        this.end = end
        processed = 0
        this.isRecorded = isRecorded
        hasAll = false
        taken.clear()
        given.clear()
        active.clear()
        open()
        region.calendar.begin(start, duration, FEW_EVENTS)
        for (r in regions) {
            for (k in 0 until r.frozen.size) takeActive(r.frozen[k], field.events.time(r.frozen[k]))
            r.meetings.forEach { i, _, _ -> takeActive(i, max(start, field.rows.state[i * STRIDE + TIME])) }
        }
        for (r in regions) {
            r.clashes.forEach { i, j, _ ->
                drop(i)
                drop(j)
            }
        }
        if (regions.any { it.failure != null }) dropAll()
        if (!processAll()) return false
        for (place in 0 until taken.size) handBack(taken.slots[place])
        return true
    }

    private fun takeActive(slot: Int, at: Double) {
        // One that is frozen may have met somebody before that.
        followFrom(slot, at)
        activate(slot)
    }

    private fun processAll(): Boolean {
        var round = 0
        while (active.size > 0) {
            rounds++
            mark = region.paths.piecesSoFar
            for (k in 0 until active.size) region.events.scan(active[k], taken.from[takenPlaces.of(active[k])])
            if (hasAll) region.process(end) { } else region.processApart(end)
            if (region.isLost || lists.isLost) return false
            clashes.clear()
            if (!hasAll && region.failure == null) findClashes()
            for (place in 0 until taken.size) taken.isActive[place] = false
            active.clear()
            if (region.failure != null || clashes.size > 0 && ++round == MOST_ROUNDS) dropAll() else settleClashes()
        }
        processed += region.impact.counted.collisions
        return true
    }

    private fun settleClashes() {
        clashes.forEach { i, j, _ ->
            giveBack(i)
            activate(i)
            giveBack(j)
            if (isAhead(j)) drop(j)
        }
    }

    /** Finds those that spheres which were followed in this round may touch before something that they have done. */
    private fun findClashes() {
        val paths = region.paths
        val receding = region.events.receding
        for (place in 0 until taken.size) {
            val i = taken.slots[place]
            val isActive = taken.isActive[place]
            if (!isActive && !paths.hasPiecesFrom(mark, i)) continue
            val first = if (isActive) firstState(place) else null
            val p = firstEntry(place)
            val from = taken.from[place]
            lists.forEach(i) { j, code ->
                val isClash = isAhead(j) &&
                    paths.meetsBefore(
                        i, mark, first, p, from, regionOf(j).paths, j, Int.MAX_VALUE,
                        field.before.state, j * STRIDE, code, start, receding,
                    ) ||
                    ownPlaces.of(j) != SlotPlaces.NONE && meetsOwn(i, first, p, from, j, code)
                if (isClash) clashes.add(i, j, 0)
            }
        }
    }

    private fun meetsOwn(i: Int, first: DoubleArray?, p: Int, from: Double, j: Int, code: Int): Boolean {
        val other = takenPlaces.of(j)
        return region.paths.meetsBefore(
            i, mark, first, p, from, region.paths, j, mark,
            firstState(other), firstEntry(other), code, start, region.events.receding,
        )
    }

    /** The path of the sphere at [place] before its first collision here. */
    private fun firstState(place: Int) = if (taken.isDropped[place]) field.before.state else given.state

    private fun firstEntry(place: Int) = (if (taken.isDropped[place]) taken.slots[place] else place) * STRIDE

    /** The sphere in [slot] is its region's again, and everybody sees it as it is. */
    private fun handBack(slot: Int) {
        region.calendar.remove(slot)
        takenPlaces.forget(slot)
        field.settle(slot)
        regionOf(slot).pending.add(slot)
    }

    /** Adds those that have left their shells in this window to [all]; they are their regions' to scan. */
    fun collectLeavers(all: IntList) {
        for (r in regions) collectLeavers(r, all)
        collectLeavers(region, all)
    }

    private fun collectLeavers(of: ListRegion, all: IntList) {
        for (k in 0 until of.leavers.size) {
            val slot = of.leavers[k]
            // Unless what led it there was taken back.
            if (!field.events.isOut(slot)) continue
            field.events.setOut(slot, false)
            all.add(slot)
            regionOf(slot).pending.add(slot)
        }
    }

    /** The greatest speed that has been met here. */
    val fastest: Double get() = region.events.fastest

    fun learn(fastest: Double) {
        region.events.learn(fastest)
    }

    /** Adds what collisions here count, see [ListPaths.addTo]. */
    fun addTo(counters: CollisionCounters, record: CollisionRecord?) {
        region.paths.addTo(counters, record, region.record)
    }

    private companion object {
        const val FEW_EVENTS = 1000

        /** Rounds after which all is taken back to the start of the window. */
        const val MOST_ROUNDS = 16
    }
}
