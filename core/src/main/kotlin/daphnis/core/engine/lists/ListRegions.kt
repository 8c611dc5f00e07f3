package daphnis.core.engine.lists

import daphnis.core.collision.CollisionCounters
import daphnis.core.engine.shares.SlotPlaces
import daphnis.core.growth.IntList
import daphnis.core.parallel.RangeLoop
import daphnis.core.step.CollisionStep

/**
 * The regions of a [ListField], and the windows of time in which they work side by side.
 *
 * ```
 *   all regions: events until the window ends ─▶ paths compared with those of later regions ─┐
 *   one thread:                             what met across borders processed anew, new lists ◀┘
 *   all regions: what has changed is seen by all ─▶ next window
 * ```
 *
 * **Why the result is that of one thread.** A region is right about a sphere of its own as long as no sphere of another
 * region touches it on the path that it gives it. (1) Of two spheres that both fly as they did when the window began,
 * one knows their contact; its region leaves it to [BorderCollisions]. (2) One that has changed was scanned then, and has
 * seen the other as long as that had not changed. (3) If both have changed, their paths are compared. (4) If one was
 * taken back, [BorderCollisions] scans it from the start of the window, sees all that nobody has changed, and compares its
 * path with the paths of those that are kept. When the window ends, each sphere of which another region, or nobody, has
 * known all is scanned again: those of (3) and (4). So all pairs are known to one of the two again.
 *
 * In a window no sphere goes farther than the skin beyond its shell, so lists have whoever it can touch.
 */
internal class ListRegions(private val field: ListField, private val loop: RangeLoop) {
    private val places = SlotPlaces()
    private val all = ArrayList<ListRegion>()
    private val regions: MutableList<ListRegion> = ArrayList()
    private val border = BorderCollisions(field, regions, places)
    private val leavers = IntList()
    val renewal = ListRenewal(field, loop)
    private val counted = CollisionCounters()
    private val span = WindowSpan()

    /** Windows, collisions processed anew to join them, and rounds of that, since the start. */
    var windows = 0L
        private set
    var processedAnew = 0L
        private set
    val rounds: Long get() = border.rounds

    /** Lists made anew one by one since the start. */
    val refreshed: Long get() = renewal.renewed + all.sumOf { it.refreshed }

    /** Events taken in the last step. */
    var taken = 0
        private set

    operator fun get(region: Int): ListRegion = regions[region]

    /** Takes over how the spheres are divided, of which none has an event. */
    fun divide() {
        while (all.size < field.regions) all.add(ListRegion(field, places))
        regions.clear()
        for (region in all) region.paths.begin()
        for (r in 0 until field.regions) {
            regions.add(all[r])
            all[r].sight.see(field.firstOf(r), field.endOf(r))
            all[r].events.reserve()
            all[r].pending.clear()
        }
        if (!field.isShared) return
        places.reserve(field.size)
        border.reserve()
    }

    /** Begins a step of [duration] in which no sphere is faster than [fastest]. */
    fun begin(duration: Double, fastest: Double) {
        val expected = maxOf(taken, field.size / LEAST_EVENTS) / field.regions
        for (slot in 0 until field.size) field.events.setPlace(slot, SphereCalendar.NONE)
        for (region in regions) region.begin(duration, fastest, expected + expected / 4)
        if (field.isShared) border.begin(duration, fastest)
        taken = 0
    }

    /** Calls [phase] with each region, on several threads. */
    fun each(phase: (region: ListRegion) -> Unit) {
        loop.run(regions.size, 1) { _, from, to -> for (r in from until to) phase(regions[r]) }
    }

    /** @return false when the step cannot be ended in this way */
    fun process(step: CollisionStep, onTheWay: Runnable): Boolean {
        counted.clear()
        val isDone = if (field.isShared) processWindows(step, onTheWay) else processWhole(step, onTheWay)
        taken = regions.sumOf { it.calendar.taken }
        return isDone
    }

    private fun processWhole(step: CollisionStep, onTheWay: Runnable): Boolean {
        val region = regions[0]
        region.open(0.0, step.record)
        if (!region.process(step.duration, onTheWay)) return false
        counted.add(region.impact.counted)
        return true
    }

    private fun processWindows(step: CollisionStep, onTheWay: Runnable): Boolean {
        step.record?.clear()
        var start = 0.0
        while (start < step.duration) {
            onTheWay.run()
            val end = span.endOf(start, step.duration, regions.maxOf { it.events.fastest }, field.space.skin)
            if (!processWindow(step, start, end)) return false
            start = end
        }
        each { it.open(step.duration, null) }
        return true
    }

    private fun processWindow(step: CollisionStep, start: Double, end: Double): Boolean {
        val limits = field.prepared.limits
        val before = counted.collisions
        limits.before = before + counted.wallCollisions
        each { region ->
            region.open(start, if (step.record == null) null else region.record)
            region.processApart(end)
        }
        if (regions.any { it.isLost }) return false
        shareSpeeds()
        each { it.compare(regions, start, end) }
        if (!border.join(start, end, step.duration, step.record != null)) return false
        leavers.clear()
        border.collectLeavers(leavers)
        renewal.renew(leavers, end)
        if (field.lists.isLost) return false
        for (region in regions) region.paths.addTo(counted, step.record, region.record)
        border.addTo(counted, step.record)
        limits.before = 0
        limits.checkWork(counted.collisions + counted.wallCollisions)
        shareSpeeds()
        each { it.settle() }
        windows++
        processedAnew += border.processed
        span.learn(
            end - start,
            (counted.collisions - before).toDouble() / field.size,
            border.processed.toDouble() / field.size,
        )
        return true
    }

    private fun shareSpeeds() {
        val fastest = maxOf(border.fastest, regions.maxOf { it.events.fastest })
        for (region in regions) region.events.learn(fastest)
        border.learn(fastest)
    }

    /** Adds what the step has counted to [counters]. */
    fun addTo(counters: CollisionCounters) {
        counters.add(counted)
    }

    private companion object {
        /** Events are expected of one sphere in so many, at least. */
        const val LEAST_EVENTS = 4
    }
}
