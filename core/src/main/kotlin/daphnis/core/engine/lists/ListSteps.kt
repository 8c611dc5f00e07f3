package daphnis.core.engine.lists

import daphnis.core.collision.StepRows
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import daphnis.core.step.CollisionStep
import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep

/**
 * Takes steps with [NeighbourLists] that are kept from step to step, in dense systems small enough for the cache, for
 * an engine that takes its other steps in another way. The cost of a collision hardly depends on the length of a
 * step then.
 *
 * ```
 *   lists made:   rows ─▶ lists ─▶ next event of each sphere
 *   each step:    comparison ─▶ events in order of time ─▶ population
 *                     │           ▲         │
 *                     └─ changed ─┘         └─ next events, lists of those that leave their shells
 * ```
 *
 * It takes the same collisions in the same order as the serial engine, see [NextEvents] for the reasons. Nothing has to
 * say what it has done to spheres between steps: each is compared with where its path has led ([Comparison]).
 *
 * One thread. After an exception the object may be used on; the population is as before then.
 */
internal class ListSteps(
    private val prepared: PreparedStep,
    private val tuning: ListTuning,
    private val loop: RangeLoop,
) {
    private val rows = StepRows()
    private val space = ListSpace()
    private val lists = NeighbourLists(rows, space, prepared.images)
    private val events = NextEvents(rows, lists, space, prepared.images)
    private val impact = ListImpact(prepared, rows, events)
    private val order = SpaceOrder()
    private val comparison = Comparison(rows, space, lists, events)

    /** Whether the rows are those of the end of the last step, and all else holds for them. */
    var isOpen = false
        private set

    /** Duration of the last step, and the steps since lists were built. */
    private var past = 0.0
    private var age = 0

    /** Steps to come that are left to others without asking. */
    private var rest = 0
    private var expected = 0

    /** Steps taken here, and lists built for all, since the start. */
    var steps = 0L
        private set
    var built = 0L
        private set

    /** Steps given up in the middle since the start: lists were too short, or a sphere went very far. */
    var voided = 0L
        private set

    /** Lists made anew one by one, spheres found changed and found wrapped, since the start. */
    val refreshed: Long get() = lists.refreshed
    val changed: Long get() = comparison.changes
    val wrapped: Long get() = comparison.wraps

    /**
     * Takes [step], if that should be quicker here.
     *
     * @param onTheWay called now and then, at last before the population is written; what it throws leaves that as it
     *   was
     * @return false when it is to be taken in another way; then nothing has changed
     * @throws IllegalArgumentException when the step is refused
     */
    fun take(step: CollisionStep, onTheWay: Runnable): Boolean {
        val wasOpen = isOpen
        isOpen = false
        val population = step.population
        if (!tuning.suits(population.size)) return false
        if (!wasOpen && rest > 0) {
            rest--
            return false
        }
        if (!ListSpace.accepts(step.boundary) || !wasOpen && !isWorth(step)) return rests()
        prepared.measure(step, loop)
        val fastest = ListSpace.fastest(prepared.reach.measured)
        if (!(fastest * step.duration <= MOST_RADII * prepared.reach.largestRadius)) return rests()
        prepared.prepareWithoutGrid()
        val goesOn = wasOpen && age < MOST_AGE && space.isOf(step.boundary) && goOn(step, fastest)
        // What is spread out by now gets no new lists.
        if (!goesOn && (wasOpen && !isWorth(step) || !begin(step, fastest))) return rests()
        impact.begin(step.record)
        if (!process(onTheWay)) {
            lists.widen()
            voided++
            return false
        }
        onTheWay.run()
        expected = events.calendar.taken
        rows.store(population, step.duration)
        step.record?.sort()
        step.counters.add(impact.counted)
        past = step.duration
        age++
        steps++
        isOpen = true
        return true
    }

    /** A step is taken in another way without asking. */
    fun drop() {
        isOpen = false
    }

    private fun rests(): Boolean {
        rest = REST
        return false
    }

    private fun isWorth(step: CollisionStep): Boolean =
        tuning.suits(step.population.size, ListSpace.fillingFactor(step.population, step.boundary))

    /** Takes over the population where nothing much has happened to it. @return false when all is to be made anew */
    private fun goOn(step: CollisionStep, fastest: Double): Boolean {
        val population = step.population
        if (rows.size != population.size || prepared.reach.largestRadius > space.largestRadius) return false
        if (!comparison.compare(population, past)) return false
        order.keep(population.size)
        load(population, step)
        events.begin(step.duration, fastest)
        events.calendar.begin(rows.size, step.duration, expected + expected / 4)
        comparison.settle()
        return !lists.isLost
    }

    /** Makes lists and events of the population. @return false when that is impossible */
    private fun begin(step: CollisionStep, fastest: Double): Boolean {
        val population = step.population
        val bounds = prepared.reach.measured
        if (!space.layOut(population, step.boundary, bounds, tuning.shell, step.duration)) return false
        order.sort(population, space)
        load(population, step)
        if (!lists.build()) return false
        events.reserve(rows.size)
        comparison.reserve(rows.size)
        events.begin(step.duration, fastest + space.fastestImage)
        events.calendar.begin(rows.size, step.duration, maxOf(expected, rows.size))
        for (i in 0 until rows.size) events.scan(i, 0.0)
        built++
        age = 0
        return true
    }

    private fun load(population: Population, step: CollisionStep) {
        rows.load(population, order.order, step.duration, step.law.guard.needsLastCollision)
    }

    /** @return false when the step cannot be ended in this way */
    private fun process(onTheWay: Runnable): Boolean {
        val calendar = events.calendar
        while (true) {
            if (calendar.taken % EVENTS_ON_THE_WAY == 0) onTheWay.run()
            val i = calendar.next()
            if (i == SphereCalendar.NONE) return true
            val now = calendar.time[i]
            val j = events.partner(i)
            if (j < 0) {
                if (events.isExit(i)) {
                    lists.refresh(i, now)
                    if (lists.isLost) return false
                    events.scan(i, now)
                } else {
                    events.due(i, now)
                }
            } else if (!events.isFresh(i)) {
                events.scan(i, now)
            } else {
                if (impact.process(now, i, j, events.image(i)) != Impact.End.DONE) return false
                if (calendar.hasMoreAt(now)) {
                    events.scanVoid(i, now)
                    events.scanVoid(j, now)
                }
            }
        }
    }

    private companion object {
        /** Steps to the next question whether lists pay. */
        const val REST = 16

        /** Events, some milliseconds of work, after which somebody may say that the step is not wanted any more. */
        const val EVENTS_ON_THE_WAY = 8192

        /** Steps in which the rounding of positions stays far below [ListSpace.margin]. */
        const val MOST_AGE = 1000

        /** How far a sphere may fly in a step, in units of the largest radius. */
        const val MOST_RADII = 1e4
    }
}
