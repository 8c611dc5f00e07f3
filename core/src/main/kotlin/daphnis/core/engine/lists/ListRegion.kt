package daphnis.core.engine.lists

import daphnis.core.collision.CollisionRecord
import daphnis.core.engine.shares.PairList
import daphnis.core.engine.shares.SlotPlaces
import daphnis.core.growth.IntList
import daphnis.core.step.Impact

/**
 * One region of a [ListField], which takes the events of its spheres in order of time, as if there were no others:
 * spheres of other regions are where they would be if nothing had happened to them since the window began. Where one of
 * its own comes to touch one of these, it is **frozen**: nothing more happens to it here, nor to those that come to touch
 * it. What would happen then is left to [BorderCollisions].
 *
 * @param places see [ListPaths]
 */
internal open class ListRegion(protected val field: ListField, places: SlotPlaces) {
    protected val table = field.events
    val sight = ListSight(field)
    val events = NextEvents(field, sight)
    val calendar: SphereCalendar get() = events.calendar
    val paths = ListPaths(field, places)
    val impact = ListImpact(field, events, paths)

    /** Collisions of the window, where there are several regions and these are wanted. */
    val record = CollisionRecord()

    /** Spheres that are to be scanned before anything else happens. */
    val pending = IntList()

    /** Spheres that have left their shells in this window, and are to get new lists at its end. */
    val leavers = IntList()

    /** Spheres that are frozen. */
    val frozen = IntList()

    /**
     * Pairs of a sphere that has changed here and one that has changed in a later region: those that may touch when
     * nothing more has happened to either, and those that may have touched before.
     */
    val meetings = PairList()
    val clashes = PairList()

    /** Lists made anew one by one in mid-step, since the start. */
    var refreshed = 0L
        private set

    /** Whether what is known of the step is void, since a sphere went too far for its list. */
    var isLost = false
        private set

    /** The two that have collided last. */
    private var first = SphereCalendar.NONE
    private var second = SphereCalendar.NONE

    /** What a law, or a limit of the step, threw in this window. */
    var failure: Exception? = null
        private set

    /** Begins a step of [duration] in which no sphere is faster than [fastest], and about so many [expected] events. */
    fun begin(duration: Double, fastest: Double, expected: Int) {
        events.begin(duration, fastest)
        calendar.begin(0.0, duration, expected)
        isLost = false
    }

    /** Begins a window at [start], whose collisions are written to [record]; null when they are not wanted. */
    fun open(start: Double, record: CollisionRecord?) {
        leavers.clear()
        frozen.clear()
        meetings.clear()
        clashes.clear()
        paths.begin()
        failure = null
        first = SphereCalendar.NONE
        second = SphereCalendar.NONE
        impact.begin(record)
        for (k in 0 until pending.size) events.scan(pending[k], start)
        pending.clear()
    }

    /** Takes all events until the time [until]. What is thrown is kept: it may be due to a guess. */
    fun processApart(until: Double) {
        try {
            process(until) { }
        } catch (e: Exception) {
            fail(e)
        } catch (e: StackOverflowError) {
            fail(IllegalStateException(e))
        }
    }

    private fun fail(cause: Exception) {
        failure = cause
        // A law throws when the two have been moved to where they touch.
        if (first != SphereCalendar.NONE) {
            paths.note(first)
            paths.note(second)
        }
    }

    /**
     * Takes all events until the time [until].
     *
     * @param onTheWay called now and then
     * @return false when the step cannot be ended in this way
     */
    fun process(until: Double, onTheWay: Runnable): Boolean {
        while (!isLost && !field.lists.isLost) {
            if (calendar.taken % EVENTS_ON_THE_WAY == 0) onTheWay.run()
            val i = calendar.next(until)
            if (i == SphereCalendar.NONE) return true
            val now = table.time(i)
            val j = events.partner(i)
            if (j < 0) {
                if (events.isExit(i)) leave(i, now) else events.due(i, now)
            } else if (!events.isFresh(i)) {
                events.scan(i, now)
            } else if (mayMeet(i, j)) {
                first = i
                second = j
                if (impact.process(now, i, j, events.image(i)) != Impact.End.DONE) return false
                if (calendar.hasMoreAt(now)) {
                    events.scanVoid(i, now)
                    events.scanVoid(j, now)
                }
            }
        }
        return false
    }

    private fun leave(i: Int, now: Double) {
        if (!field.isShared) {
            field.lists.refresh(i, now)
            refreshed++
            if (field.lists.isLost) return
        } else if (table.isOut(i)) {
            isLost = true
            return
        } else {
            table.setOut(i, true)
            leavers.add(i)
        }
        events.scan(i, now)
    }

    /** Whether [i], the next event of which is a collision with [j], is to be processed here. */
    protected open fun mayMeet(i: Int, j: Int): Boolean {
        if (!field.isShared) return true
        if (sight.owns(j) && !field.isFrozen[j]) return true
        calendar.remove(i)
        field.isFrozen[i] = true
        frozen.add(i)
        return false
    }

    /**
     * Notes which spheres that have changed here may have met, in the window from [start] to [end], those that have
     * changed in later regions, which [others] are; and that the next events of the two are to be found with both known.
     */
    fun compare(others: List<ListRegion>, start: Double, end: Double) {
        val lists = field.lists
        for (k in 0 until paths.atBorder.size) {
            val i = paths.atBorder[k]
            var isNear = false
            lists.forEach(i) { j, code ->
                if (j >= sight.end) {
                    val other = others[field.regionOf(j)]
                    if (other.paths.hasChanged(j)) {
                        isNear = true
                        when (paths.meet(i, other.paths, j, code, start, end, events.receding)) {
                            Meeting.NONE -> Unit
                            Meeting.LAST -> meetings.add(i, j, code)
                            Meeting.BEFORE -> clashes.add(i, j, code)
                        }
                    }
                }
            }
            if (isNear) pending.add(i)
        }
    }

    /** What has not been taken back holds, and everybody sees it from now on. */
    fun settle() {
        for (place in 0 until paths.changed.size) {
            if (paths.clusters.isLive(place)) field.settle(paths.changed[place])
        }
        for (k in 0 until frozen.size) field.isFrozen[frozen[k]] = false
    }

    private companion object {
        /** Events, some milliseconds of work, after which somebody may say that the step is not wanted any more. */
        const val EVENTS_ON_THE_WAY = 8192
    }
}
