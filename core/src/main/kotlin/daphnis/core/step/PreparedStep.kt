package daphnis.core.step

import daphnis.core.api.EngineApi
import daphnis.core.boundary.prepare
import daphnis.core.collision.Merging
import daphnis.core.collision.PairStates
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.contactTime
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Bonds
import daphnis.core.population.SphereColumns
import daphnis.core.queue.EventSink
import daphnis.core.search.Grid
import daphnis.core.search.GridSort
import daphnis.core.search.Reach
import daphnis.core.search.RowBounds
import daphnis.core.search.StepBounds
import daphnis.core.search.SwollenSpheres
import daphnis.core.space.Images
import daphnis.core.wall.WallContact

/**
 * A step made ready for its collisions: the single owner of the spheres' order, their rows, the bounds on how far they
 * may go, the walls and the limits. An engine and its serial fallback use the same one, one after the other.
 *
 * ```
 *   measure ─▶ prepare ─▶ collisions ─▶ store
 *                 ▲           │
 *                 └─ enlarge ─┘   when a sphere goes beyond the bound
 * ```
 *
 * [measure] may begin a step at any time; another call out of turn throws an IllegalStateException. Between [prepare]
 * and [store] any number of threads may read, each with its own [candidates]. Which thread may write rows is up to the
 * engine.
 *
 * All memory is kept from step to step.
 *
 * @param sort how the grid is built; affects only the time it takes
 */
@EngineApi
public class PreparedStep @JvmOverloads constructor(sort: GridSort = GridSort.COUNTING) {
    /** Puts the spheres in cell order. */
    public val grid: Grid = Grid(sort)

    /** The spheres in that order. */
    public val rows: StepRows = StepRows()

    internal val reach = Reach()
    internal val bounds = RowBounds()
    internal val walls = WallContact()
    internal val limits = StepLimits()

    /** The step that is prepared. */
    internal lateinit var step: CollisionStep
        private set

    private var stage = Stage.UNMEASURED

    /** The spheres that are moved: those of the step, or a part of them. */
    private lateinit var spheres: SphereColumns

    /** See [Grid.build]. */
    private var middle = Grid.WHOLE

    /** Length of the present step; later contacts are not potential collisions of it. */
    public var duration: Double = 0.0
        private set

    /** The states of pairs; null where spheres do nothing to one another besides impacts. */
    internal var states: PairStates? = null
        private set

    /** How much farther than contact a search has to look. */
    internal val swelling: Double get() = states?.let { it.reach * WIDER } ?: if (merges) mergeRoom else 1.0

    /** Whether spheres merge, and how much larger than it is each is looked for then. */
    private val merges: Boolean get() = step.law.merging != null
    private var mergeRoom = Merging.ROOM
    private val swollen = SwollenSpheres()

    /** How much farther apart than two spheres that touch those may be that come to an edge. */
    internal val beyondContact: Double get() = 2 * reach.largestRadius * (1 - 1 / swelling)

    /** How far a sphere can go along x, y, z, and with it what it takes up more than at the start. */
    internal val farthest: DoubleArray get() {
        val more = if (mergeRoom == Merging.ROOM) 0.0 else (mergeRoom - Merging.ROOM) * reach.largestRadius
        return if (more == 0.0) reach.bound else DoubleArray(reach.bound.size) { reach.bound[it] + more }
    }

    /** [spheres] as a search has to see them. */
    private fun seen(spheres: SphereColumns) = if (swelling == 1.0) spheres else swollen.take(spheres, swelling)

    /**
     * The time at which the spheres in the slots [first] of [a] and [second] of [b] meet, or come to an edge of their
     * interaction, see [daphnis.core.collision.contactTime].
     */
    internal fun meetingTime(a: StepRows, first: Int, b: StepRows, second: Int, image: Int): Double =
        meetingTime(stateOf(a, first, b, second), a.state, first * STRIDE, b.state, second * STRIDE, image)

    /** The same for a pair in [state] whose rows begin at entry [p] of [a] and entry [q] of [b]. */
    internal fun meetingTime(state: Int, a: DoubleArray, p: Int, b: DoubleArray, q: Int, image: Int): Double =
        states?.time(state, a, p, b, q, image, images) ?: contactTime(a, p, b, q, image, images)

    /** The state of the pair in the slots [first] of [a] and [second] of [b], see [PairStates]. */
    internal fun stateOf(a: StepRows, first: Int, b: StepRows, second: Int): Int =
        states?.of(a, first, b, second) ?: Bonds.UNBOUND

    /** Counts the calls of [prepare], so that other objects can see that what they know of the step is stale. */
    internal var version = 0L
        private set

    /** The images of this step. */
    internal val images: Images get() = grid.images

    /** The same of [step] before it is measured. */
    internal fun imagesOf(step: CollisionStep): Images {
        images.prepare(step.boundary, step.start)
        return images
    }

    /**
     * Takes over [step] and bounds how far spheres can go in it.
     *
     * @throws IllegalArgumentException when the step is refused, see [Reach.measure]
     */
    @JvmOverloads
    public fun measure(step: CollisionStep, loop: RangeLoop = InlineLoop) {
        measureAlong(step, loop, along = null)
    }

    /**
     * The same, and calls [along], if there is one, with pieces of the spheres, which are in the cache afterwards. What
     * that has done counts only when the step is not refused.
     */
    internal fun measureAlong(step: CollisionStep, loop: RangeLoop, along: StepBounds.AlongPieces?) {
        take(step, step.population, Grid.WHOLE)
        reach.look(seen(step.population), step.boundary, everywhere = false, loop, along)
        reach.apply(step.boundary, duration)
        stage = Stage.MEASURED
    }

    /**
     * The same for a step whose spheres are a part of all: [merge] makes what was measured of them that of all.
     * Positions are measured along every axis.
     */
    internal fun measure(step: CollisionStep, loop: RangeLoop, merge: (StepBounds) -> Unit) {
        take(step, step.population, Grid.WHOLE)
        reach.look(seen(step.population), step.boundary, everywhere = true, loop)
        merge(reach.measured)
        reach.apply(step.boundary, duration)
        stage = Stage.MEASURED
    }

    /**
     * Takes over the step of [whole], which has been measured, for some of its spheres only: for [part], which lies
     * about [middle], see [Grid.build]. Such a step is not to be written with [store].
     */
    internal fun takePart(whole: PreparedStep, part: SphereColumns, middle: DoubleArray) {
        take(whole.step, part, middle)
        reach.take(whole.reach)
        stage = Stage.MEASURED
    }

    private fun take(step: CollisionStep, spheres: SphereColumns, middle: DoubleArray) {
        stage = Stage.UNMEASURED
        this.step = step
        this.spheres = spheres
        this.middle = middle
        duration = step.duration
        states = step.law.edges?.states
        mergeRoom = Merging.ROOM
        walls.prepare(step.boundary.walls, step.law, step.start, step.duration)
    }

    /** Sorts the spheres into the grid and copies them, as they are at the start of the step. */
    @JvmOverloads
    public fun prepare(loop: RangeLoop = InlineLoop) {
        requireStage(Stage.MEASURED, "prepare() follows measure() or enlarge()")
        grid.swelling = swelling
        // Of what has merged those around know, and of the edges of an interaction both have to.
        grid.outlook = if (states == null) 1.0 else swelling
        grid.build(seen(spheres), step.boundary, step.start, duration, reach.bound, loop, step.search, middle)
        rows.changesMass = merges
        rows.load(spheres, grid.order, duration, step.law.guard.needsLastCollision, loop)
        // They know where a sphere can be that goes straight, and not one that has merged.
        if (merges) bounds.rest() else bounds.measure(grid, rows, duration, loop)
        limits.start(rows.size, step.start)
        version++
        stage = Stage.PREPARED
    }

    /**
     * In place of [prepare], for an engine which finds potential collisions by itself and keeps rows of its own: there
     * are images and limits, but neither a grid nor rows. [measure] follows, for the next step or for this one again.
     */
    internal fun prepareWithoutGrid() {
        requireStage(Stage.MEASURED, "prepareWithoutGrid() follows measure()")
        images.prepare(step.boundary, step.start)
        bounds.rest()
        limits.start(spheres.size, step.start)
        version++
        stage = Stage.UNMEASURED
    }

    /**
     * Enlarges the bound while the step goes on, for an engine whose search does not rely on it; see [enlarge].
     *
     * @throws IllegalArgumentException as [enlarge]
     */
    internal fun widen(rows: StepRows, first: Int, second: Int) {
        reach.enlarge(rows, first, second, spheres, duration)
    }

    private fun requireStage(required: Stage, rule: String) {
        check(stage == required) { "the step is $stage: $rule" }
    }

    /** Finds potential collisions of this and all later steps, for one thread. */
    public fun candidates(): Candidates = GridCandidates(this)

    /** Whether the sphere at [place] of [rows], if nothing more happens to it, ends the step beyond the bound. */
    internal fun isOutrun(rows: StepRows, place: Int): Boolean =
        if (merges && Merging.hasMerged(rows, place, spheres)) {
            isMergedBeyond(rows, place)
        } else {
            reach.isOutrun(rows, place, spheres, duration)
        }

    private fun isMergedBeyond(rows: StepRows, place: Int) =
        Merging.isBeyond(rows, place, spheres, reach.bound, mergeRoom, duration)

    /**
     * Enlarges the bound for the spheres at [first] and [second] (negative for none) of [rows], which went beyond it.
     *
     * @throws IllegalArgumentException when it cannot be enlarged, see [Reach.enlarge]
     */
    public fun enlarge(rows: StepRows, first: Int, second: Int) {
        requireStage(Stage.PREPARED, "enlarge() follows prepare()")
        stage = Stage.UNMEASURED
        val both = listOf(first, second).filter { it >= 0 }
        if (merges && both.any { Merging.hasMerged(rows, it, spheres) && isMergedBeyond(rows, it) }) {
            mergeRoom *= Merging.MORE
        } else {
            reach.enlarge(rows, first, second, spheres, duration)
        }
        stage = Stage.MEASURED
    }

    /** Queues the potential collisions of the sphere at [place] of [rows] with walls, until the time [until]. */
    internal fun queueWalls(rows: StepRows, place: Int, sink: EventSink, until: Double = duration) {
        walls.each(rows, place, until) { t, partner -> sink.add(t, place, partner, 0) }
    }

    /** Moves every sphere to the end of the step and writes all to the population, see [StepRows.store]. */
    @JvmOverloads
    public fun store(loop: RangeLoop = InlineLoop) {
        requireStage(Stage.PREPARED, "store() follows prepare()")
        stage = Stage.UNMEASURED
        rows.store(step.population, duration, loop)
    }

    private companion object {
        /** Room for pairs that rounding has put beyond their outermost edge. */
        const val WIDER = 1 + 1e-8
    }

    private enum class Stage { UNMEASURED, MEASURED, PREPARED }
}
