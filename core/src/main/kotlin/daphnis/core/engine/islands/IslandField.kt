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
 * meet nobody else within a **window** of time, so that its collisions can be processed alone, in its own order of
 * time, without asking others.
 *
 * ```
 *   time ─▶  │ window 0   │ window 1 │ window 2     │ …      a window is some slices of the step
 *   sphere a ├──┐         │          │              │
 *   sphere b ├──┴──┐      │          │         ┌────┤        {a b c} is one island of window 0, {d e} another;
 *   sphere c ├─────┴──────┤          ├─────────┴────┤        everybody else flies straight on and is touched by nobody
 *   sphere d ├───────┐    │          │              │
 *   sphere e ├───────┴────┤          │              │
 * ```
 *
 * **Why the bits are those of the serial engine.** A sphere's path changes only at its own collisions, and contact time
 * and outcome are pure functions of the two states. Suppose that in a window every island has been processed alone, in
 * its order, and that no two pieces of path that belong to different islands, or to an island and a sphere of none,
 * touch each other. Then these paths are *the* paths: go through the serial engine's collisions in order; the first
 * that is missing here, or differs, would be a contact of two pieces of path that are both right up to then, hence a
 * contact between different islands, which there is none of. Who grew which island, in what order and on which thread
 * does not enter.
 *
 * **How that is ensured.** Islands are grown optimistically and checked afterwards:
 * 1. *Seeds*: all potential collisions of the window between spheres as they are at its start. Whoever shares a seed
 *    shares an island.
 * 2. *Growth*: an island is processed in order of time on copies of its rows. After a collision the new path is
 *    compared with everybody whom it could touch. Who belongs to nobody and is hit joins the island (one atomic claim).
 *    Who belongs to another island is noted as *suspect*: what it does in this window is not known yet.
 * 3. *Check*, when all islands are done: every suspect pair is compared piece of path by piece of path. Pieces that
 *    were there at the start need no comparison among themselves: that is what the seeds were. Two new pieces, or a new
 *    and an old one, are compared because of the fence between marking a sphere and searching from it: of two islands
 *    at least one sees the mark of the other. Islands that touch are dropped, merged and processed again, until none
 *    touch. Copies are dropped, nothing has to be restored.
 * 4. *Commit*: copies become the state.
 *
 * Phases are separated by barriers or messages; within a phase the columns of a sphere are written by its owner only,
 * see [IslandBoard].
 */
@EngineApi
public class IslandField(workers: Int, internal val prepared: PreparedStep = PreparedStep()) {
    /** The grid of this step. */
    public val grid: Grid get() = prepared.grid

    /**
     * The state at the start of the window. Written by [prepare] and when islands are committed; read by all. The local
     * time of a sphere that has been taken into an island is NaN.
     */
    public val rows: StepRows = prepared.rows

    /** Which island every sphere belongs to. */
    internal val board = IslandBoard(rows, workers)

    internal var limits = IslandLimits(0)
        private set

    /** End of the window at hand, from the start of the step. */
    internal var windowEnd = 0.0

    /** Whether a sphere outran the bound, so that the attempt at the step is void: call [enlarge], then [prepare]. */
    @Volatile
    public var isOutrun: Boolean = false
        private set

    // Where the two stand whose collision made one of them outrun the bound.
    private var outrunRows = rows
    private var outrunFirst = NOBODY
    private var outrunSecond = NOBODY
    private var enlarged = 0

    /** Whether somebody has given up: processing goes on no further. */
    @Volatile
    internal var stopped = false

    /** Number of spheres. */
    public val size: Int get() = rows.size

    /**
     * Bounds how far anybody can go in the step. Once before the first [prepare] of a step.
     *
     * @throws IllegalArgumentException when the step is refused, see [Reach.measure]
     */
    public fun measure(step: CollisionStep, loop: RangeLoop = InlineLoop) {
        enlarged = 0
        prepared.measure(step, loop)
    }

    /**
     * Makes room for the sphere that outran the bound.
     *
     * @throws IllegalArgumentException when there is none, see [Reach.enlarge]; since the path of the sphere was a
     *   guess, that does not mean that the step is refused
     * @throws IllegalStateException when that has helped too often: only false paths go on and on like that
     */
    public fun enlarge() {
        check(++enlarged <= MOST_ENLARGED) { "false paths outrun every bound" }
        prepared.enlarge(outrunRows, outrunFirst, outrunSecond)
    }

    /**
     * Notes that at place [first] or [second] (negative for none) of [local] a sphere outruns the bound, and tells all
     * workers to stop.
     */
    @Synchronized
    internal fun outran(local: StepRows, first: Int, second: Int) {
        outrunRows = local
        outrunFirst = first
        outrunSecond = second
        isOutrun = true
        stopped = true
    }

    /** Sorts the spheres into the grid and copies them; nobody belongs to an island. */
    public fun prepare(loop: RangeLoop = InlineLoop) {
        isOutrun = false
        stopped = false
        prepared.prepare(loop)
        limits = IslandLimits(rows.size)
        board.prepare(rows.size)
    }

    /** Brings every sphere to the end of the step and writes all back. */
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

        /** Times that a step is begun again with a larger bound. */
        const val MOST_ENLARGED = 30
    }
}
