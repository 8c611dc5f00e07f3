package daphnis.core.engine.lists

import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import daphnis.core.step.CollisionStep
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
    private val threads: RangeLoop,
) {
    private val field = ListField(prepared)

    /** One region is one thread's. */
    private val loop: RangeLoop get() = if (this.field.isShared) threads else InlineLoop
    private val rows = field.rows
    private val space = field.space
    private val lists = field.lists
    private val order = SpaceOrder()

    /** The regions, and how they share windows. */
    val regions = ListRegions(field, threads)
    private val comparison = Comparison(field, regions)

    /** Whether the rows are those of the end of the last step, and all else holds for them. */
    private var isOpen = false

    /** Duration of the last step, and the steps since lists were built. */
    private var past = 0.0
    private var age = 0

    /** Steps to come that are left to others without asking. */
    private var rest = 0

    /** Steps taken here, and lists built for all, since the start. */
    var steps = 0L
        private set
    var built = 0L
        private set

    /** Steps given up in the middle since the start: lists were too short, or a sphere went very far. */
    var voided = 0L
        private set

    /** Lists made anew one by one, spheres found changed and found wrapped, since the start. */
    val refreshed: Long get() = regions.refreshed
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
        if (!regions.process(step, onTheWay)) {
            lists.widen()
            voided++
            return false
        }
        onTheWay.run()
        rows.store(population, step.duration, loop)
        step.record?.sort()
        regions.addTo(step.counters)
        past = step.duration
        age++
        steps++
        isOpen = true
        return true
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
        regions.begin(step.duration, fastest)
        comparison.settle()
        return !lists.isLost
    }

    /** Makes lists and events of the population. @return false when that is impossible */
    private fun begin(step: CollisionStep, fastest: Double): Boolean {
        val population = step.population
        val bounds = prepared.reach.measured
        val count = tuning.regions(population.size)
        val skin = if (count > 1) ListTuning.SKIN else 0.0
        if (!space.layOut(population, step.boundary, bounds, ListTuning.SHELL, skin)) return false
        field.divide(population.size, count)
        order.sort(population, space, field.regions, field.slotsARegion)
        load(population, step)
        if (!lists.build()) return false
        field.events.reserve(rows.size)
        regions.divide()
        regions.begin(step.duration, fastest)
        regions.each { for (i in it.sight.first until it.sight.end) it.events.scan(i, 0.0) }
        built++
        age = 0
        return true
    }

    private fun load(population: Population, step: CollisionStep) {
        val tracks = step.law.guard.needsLastCollision
        rows.load(population, order.order, step.duration, tracks, loop)
        if (field.isShared) field.before.load(population, order.order, step.duration, tracks, loop)
    }

    private companion object {
        /** Steps to the next question whether lists pay. */
        const val REST = 16

        /** Steps in which the rounding of positions stays far below [ListSpace.margin]. */
        const val MOST_AGE = 1000

        /** How far a sphere may fly in a step, in units of the largest radius. */
        const val MOST_RADII = 1e4
    }
}
