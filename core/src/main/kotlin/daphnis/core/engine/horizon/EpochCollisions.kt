package daphnis.core.engine.horizon

import daphnis.core.collision.CollisionCounters
import daphnis.core.parallel.OptionalLoop
import daphnis.core.population.PopulationColumns
import daphnis.core.step.CollisionStep
import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep

/**
 * The collisions of the steps of an epoch, window by window: those of all spheres on one thread, or shared among groups
 * where that is [wanted][EpochPlan.sharesCollisions] and there are enough.
 *
 * @param isEager whether they are shared in any case
 */
internal class EpochCollisions(
    private val prepared: PreparedStep,
    private val space: EpochSpace,
    private val loop: OptionalLoop,
    private val plan: EpochPlan,
    private val isEager: Boolean,
    private val witness: Impact.Witness?,
) {
    private val frame = space.frame
    private val source = RowSource()

    /** One for each group; the first is also that of [whole]. */
    val calendars = List(loop.workers) { PairCalendar(space.lines) }
    private val wholePlaces = SlotPlaces()

    /** What one thread does alone. */
    val whole = group(wholePlaces, calendars[0], loop.workers)
    private val groupPlaces = SlotPlaces()
    private val groups =
        if (space.isShared) calendars.mapIndexed { g, calendar -> group(groupPlaces, calendar, g) } else emptyList()
    val shared = SharedCollisions(prepared, space, calendars, groups, groupPlaces, whole, loop, isPatient = isEager)

    /** One for each worker. */
    val workers: List<CollisionGroup> = groups.ifEmpty { listOf(whole) }

    private var spheres = 0
    private var tracks = false
    private lateinit var step: CollisionStep
    private lateinit var carried: Carried

    /** Whether groups process the collisions of the present step, and whether their last attempt failed. */
    private var isShared = false
    var hasFailed = false

    /** What was looked at in the present epoch, or its last window, in the nanoseconds of [EpochCost]. */
    val work: Double get() = whole.work.total + groups.sumOf { it.work.total }

    /** Makes room for [spheres]. */
    fun reserve(spheres: Int) {
        this.spheres = spheres
        wholePlaces.reserve(spheres)
    }

    /** All lines have been drawn anew, for an epoch or a window of it; [filter] dismisses lines. */
    fun beginLines(filter: LineFilter) {
        for (calendar in calendars) calendar.begin(frame.steps)
        whole.beginEpoch(filter)
        for (group in groups) group.beginEpoch(filter)
        if (groups.isNotEmpty()) shared.divide(spheres)
    }

    /**
     * Begins [step].
     *
     * @param order index in the spheres of [carried] by slot; null when the two are the same
     * @param tracks whether the times of collisions are kept
     */
    fun begin(step: CollisionStep, carried: Carried, order: IntArray?, tracks: Boolean) {
        this.step = step
        this.carried = carried
        this.tracks = tracks
        source.begin(carried.spheres, spheres, order, frame.duration, tracks)
    }

    /** Goes on in another window. @param indexAt index by slot from now on, and [slotAt] the reverse */
    fun goOn(indexAt: IntArray, slotAt: IntArray) {
        source.goOn(indexAt, slotAt)
    }

    /** Processes the collisions of a [window]. @return false when the step cannot be ended in this way */
    fun process(window: Int): Boolean {
        if (window == 0) {
            isShared = groups.isNotEmpty() && !loop.isAlone && (isEager || plan.sharesCollisions && shared.isWorthIt())
        }
        return if (isShared) share(window) else processAlone(window)
    }

    private fun share(window: Int): Boolean {
        val isDone = shared.process(step, tracks, isFirst = window == 0)
        hasFailed = shared.hasFailed
        val n = spheres.toDouble()
        if (!hasFailed) plan.joined(shared.collisions / n, shared.processedAnew / n, shared.compared / n)
        return isDone
    }

    private fun processAlone(window: Int): Boolean {
        if (window == 0) whole.begin(tracks, keepsPaths = false)
        whole.work.start(parts = 1)
        if (window == 0) whole.open(carried.record) else whole.goOn()
        for (calendar in calendars) calendar.forEachDue(frame.step) { i, j, code -> whole.ask(i, j, code) }
        return whole.process().also { whole.rest() }
    }

    /** Writes the spheres with rows to [columns] after a [window]; everybody knows their lines from now on. */
    fun store(columns: PopulationColumns, window: Int) {
        if (isShared) {
            shared.store(columns, goesOn = window + 1 < frame.windows)
        } else {
            whole.held.store(columns, frame.duration)
            whole.held.forEachSlot { space.settleLine(it) }
        }
    }

    /** Adds what the step has counted to [counters]. */
    fun addTo(counters: CollisionCounters) {
        if (isShared) shared.addTo(counters) else counters.add(whole.impact.counted)
    }

    private fun group(places: SlotPlaces, calendar: PairCalendar, number: Int) =
        CollisionGroup(prepared, space, calendar, places, source, number, loop.workers + 1, witness)
}
