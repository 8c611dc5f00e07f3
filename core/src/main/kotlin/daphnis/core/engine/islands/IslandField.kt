package daphnis.core.engine.islands

import daphnis.core.api.EngineApi
import daphnis.core.collision.StepRows
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.search.Grid
import daphnis.core.search.Reach
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep

/**
 * What the workers of a step share when collisions are processed by islands. An **island** is a set of spheres that
 * meet no other sphere within a **window** of time, so that its collisions can be processed alone, in their own time
 * order, without knowledge of other spheres.
 *
 * ```
 *   time ─▶  │ window 0   │ window 1 │ window 2     │ …      a window is some slices of the step
 *   sphere a ├──┐         │          │              │
 *   sphere b ├──┴──┐      │          │         ┌────┤        {a b c} is one island of window 0, {d e} another;
 *   sphere c ├─────┴──────┤          ├─────────┴────┤        every other sphere moves straight on, touched by none
 *   sphere d ├───────┐    │          │              │
 *   sphere e ├───────┴────┤          │              │
 * ```
 *
 * **Why the bits are those of the serial engine.** A sphere's path changes only at its own collisions, and contact time
 * and outcome are pure functions of the two states. Suppose that in a window every island has been processed alone, in
 * time order, and that no two pieces of path touch each other which belong to different islands, or to an island and a
 * sphere of none. Then these paths are *the* paths. To see this, go through the serial engine's collisions in order.
 * The first one that is missing here, or that differs, would be a contact of two pieces of path that are both right up
 * to then. It would hence be a contact between different islands, and there is none. Which worker grew which island, in
 * what order and on which thread, does not enter.
 *
 * **How that is ensured.** Islands are grown optimistically and checked afterwards:
 * 1. *Seeds*: all potential collisions of the window between spheres as they are at its start. Spheres which share a
 *    seed share an island.
 * 2. *Growth*: an island is processed in time order on copies of its rows. After a collision the new path is compared
 *    with every sphere that it could touch. A sphere that belongs to no island and is hit joins the island (one atomic
 *    claim). A sphere that belongs to another island is noted as *suspect*: its path in this window is not known yet.
 * 3. *Check*, when all islands are done: every suspect pair is compared piece of path by piece of path. Pieces that
 *    were there at the start need no comparison among themselves, since the seeds were that comparison. Two new pieces,
 *    or a new and an old one, are compared because of the fence between marking a sphere and searching from it: of two
 *    islands at least one sees the mark of the other. Islands that touch are dropped, merged and processed again, until
 *    none touch. Only copies are dropped, so nothing has to be restored.
 * 4. *Commit*: copies become the state.
 *
 * Phases are separated by barriers or messages. Within a phase only its owner writes the columns of a sphere, see
 * [IslandBoard].
 */
@EngineApi
public class IslandField @JvmOverloads constructor(workers: Int, internal val prepared: PreparedStep = PreparedStep()) {
    /** The grid of this step. */
    public val grid: Grid get() = prepared.grid

    /**
     * The state at the start of the window. Written by [prepare] and when islands are committed; read by all. The local
     * time of a sphere that has been taken into an island is [StepRows.UNKNOWN].
     */
    public val rows: StepRows = prepared.rows

    /** Which island every sphere belongs to. */
    internal val board = IslandBoard(rows, workers)

    internal var limits = IslandLimits(0)
        private set

    /** End of the window at hand, from the start of the step. */
    internal var windowEnd = 0.0

    /**
     * Whether a sphere went beyond the bound, so that the attempt at the step is void: call [enlarge], then [prepare].
     */
    @Volatile
    public var isOutrun: Boolean = false
        private set

    // The places of the two spheres whose collision made one of them go beyond the bound.
    private var outrunRows = rows
    private var outrunFirst = NOBODY
    private var outrunSecond = NOBODY
    private var enlarged = 0

    /** Whether a worker has given up, so that processing stops. */
    @Volatile
    internal var stopped = false

    /** Number of spheres. */
    public val size: Int get() = rows.size

    /**
     * Bounds how far any sphere can go in the step. To be called once before the first [prepare] of a step.
     *
     * @throws IllegalArgumentException when the step is refused, see [Reach.measure]
     */
    @JvmOverloads
    public fun measure(step: CollisionStep, loop: RangeLoop = InlineLoop) {
        enlarged = 0
        prepared.measure(step, loop)
    }

    /**
     * Enlarges the bound for the sphere that went beyond it.
     *
     * @throws IllegalArgumentException when it cannot be enlarged, see [Reach.enlarge]; since the path of the sphere
     *   was a guess, that does not mean that the step is refused
     * @throws IllegalStateException when it has been enlarged too often: only false paths need that
     */
    public fun enlarge() {
        check(++enlarged <= MOST_ENLARGED) { "false paths outrun every bound" }
        prepared.enlarge(outrunRows, outrunFirst, outrunSecond)
    }

    /**
     * Notes that the sphere at place [first] or [second] (negative for none) of [local] goes beyond the bound, and
     * tells all workers to stop.
     */
    @Synchronized
    internal fun outran(local: StepRows, first: Int, second: Int) {
        outrunRows = local
        outrunFirst = first
        outrunSecond = second
        isOutrun = true
        stopped = true
    }

    /** Sorts the spheres into the grid and copies them; then none belongs to an island. */
    @JvmOverloads
    public fun prepare(loop: RangeLoop = InlineLoop) {
        isOutrun = false
        stopped = false
        prepared.prepare(loop)
        limits = IslandLimits(rows.size)
        board.prepare(rows.size)
    }

    /** Moves every sphere to the end of the step and writes all back. */
    @JvmOverloads
    public fun store(loop: RangeLoop = InlineLoop) {
        prepared.store(loop)
        board.leaveClean()
    }

    /** Tells all workers to stop: the step has failed or is void. */
    public fun stop() {
        stopped = true
    }

    private companion object {
        const val NOBODY = -1

        /** How many times a step may be begun again with a larger bound. */
        const val MOST_ENLARGED = 30
    }
}
