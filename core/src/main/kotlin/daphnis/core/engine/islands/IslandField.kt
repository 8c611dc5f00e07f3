package daphnis.core.engine.islands

import daphnis.core.collision.StepRows
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.search.Grid
import daphnis.core.search.Reach
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import daphnis.core.step.StepLimits
import java.lang.invoke.MethodHandles
import java.lang.invoke.VarHandle

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
 * Phases are separated by barriers or messages; within a phase the columns of a sphere are written by the one who owns
 * it.
 */
public class IslandField(private val workers: Int, internal val prepared: PreparedStep = PreparedStep()) {
    /** The grid of this step. */
    public val grid: Grid get() = prepared.grid

    /**
     * The state at the start of the window. Written by [prepare] and when islands are committed; read by all. The local
     * time of a sphere that has been taken into an island is NaN, see [IslandWorker].
     */
    public val rows: StepRows = prepared.rows

    /** Four numbers a slot, [PARENT], [OWNER], [ATTEMPT], [PLACE]. */
    internal var ticket = IntArray(0)

    /** First seed of the island with this root, −1 when there is none. */
    internal var seedHead = IntArray(0)
    internal val seeds = Seeds()

    internal val stepLimits: StepLimits get() = prepared.limits
    internal var limits = IslandLimits(0)
        private set
    internal val duration: Double get() = prepared.duration
    internal var records = false

    /** End of the window at hand, from the start of the step. */
    internal var windowEnd = 0.0

    /**
     * Row of a sphere that outran the bound on its reach: in [outrunRows], −1 when none did; then the step has to be
     * done again.
     */
    @Volatile
    internal var outrunner = FREE
    private var outrunRows = rows
    private var enlarged = 0

    /** Whether somebody has given up: processing goes on no further. */
    @Volatile
    internal var stopped = false
    private var clean = false

    /**
     * Whether a sphere outran the bound, so that the attempt at the step is void: call [enlarge] and [prepare] again.
     */
    public val isOutrun: Boolean get() = outrunner != FREE

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
        prepared.enlarge(outrunRows, outrunner, FREE)
    }

    /** Notes that row [k] of [local] outruns the bound, and tells all workers to stop. */
    @Synchronized
    internal fun outran(local: StepRows, k: Int) {
        outrunRows = local
        outrunner = k
        stopped = true
    }

    /** Sorts the spheres into the grid and copies them; nobody belongs to an island. */
    public fun prepare(step: CollisionStep, loop: RangeLoop = InlineLoop) {
        records = step.record != null
        limits = IslandLimits(step.population.size)
        outrunner = FREE
        stopped = false
        prepared.prepare(loop)
        if (seedHead.size < rows.size) {
            ticket = IntArray(rows.size * TICKET)
            seedHead = IntArray(rows.size)
            clean = false
        }
        if (!clean) forget()
        clean = false
    }

    /** Brings every sphere to the end of the step and writes all back. */
    public fun store(step: CollisionStep, loop: RangeLoop = InlineLoop) {
        prepared.store(loop)
        // All islands were committed, which left everything as it was.
        clean = true
    }

    private fun forget() {
        for (slot in seedHead.indices) release(slot)
    }

    /** Makes [slot] one that belongs to nobody and has no seeds. */
    internal fun release(slot: Int) {
        val p = slot * TICKET
        ticket[p + PARENT] = slot
        ticket[p + OWNER] = FREE
        ticket[p + ATTEMPT] = 0
        ticket[p + PLACE] = FREE
        seedHead[slot] = FREE
    }

    /** Whether [slot] takes part in a seed of this window. */
    internal fun isSeeded(slot: Int): Boolean = seedHead[slot] != FREE || ticket[slot * TICKET + PARENT] != slot

    internal fun owner(slot: Int): Int = ticket[slot * TICKET + OWNER]

    internal fun attempt(slot: Int): Int = ticket[slot * TICKET + ATTEMPT]

    internal fun place(slot: Int): Int = ticket[slot * TICKET + PLACE]

    /** Tells all workers to stop: the step has failed or is void. */
    public fun stop() {
        stopped = true
    }

    internal fun find(slot: Int): Int {
        var k = slot
        while (true) {
            val p = ticket[k * TICKET + PARENT]
            if (p == k) return k
            val q = ticket[p * TICKET + PARENT]
            // Only ever from an ancestor to a higher one, so that writes of several workers do no harm.
            if (q != p) ticket[k * TICKET + PARENT] = q
            k = q
        }
    }

    /** Puts the islands of two spheres into one. Any number of workers at once. */
    internal fun union(a: Int, b: Int) {
        while (true) {
            val p = find(a)
            val q = find(b)
            if (p == q) return
            val low = minOf(p, q)
            val high = maxOf(p, q)
            if (ENTRY.compareAndSet(ticket, high * TICKET + PARENT, high, low)) return
        }
    }

    /**
     * Takes a sphere that belongs to nobody for the island [root]; false when another was quicker. Any number of
     * workers at once.
     */
    internal fun claim(slot: Int, root: Int): Boolean = ENTRY.compareAndSet(ticket, slot * TICKET + OWNER, FREE, root)

    /** Hangs [seed] into the list of [root]; true for the first one. Any number of workers at once. */
    internal fun hang(seed: Int, root: Int): Boolean {
        val before = ENTRY.getAndSet(seedHead, root, seed) as Int
        seeds.next[seed] = before
        return before == FREE
    }

    /** The worker that made [attempt], and which of its attempts that is. */
    internal fun workerOf(attempt: Int): Int = (attempt - 1) % workers

    internal fun indexOf(attempt: Int): Int = (attempt - 1) / workers

    internal fun attemptNumber(worker: Int, index: Int): Int = index * workers + worker + 1

    internal companion object {
        const val FREE = -1

        /** Times that a step is begun again with a larger bound. */
        private const val MOST_ENLARGED = 30

        const val TICKET = 4

        /** Union-find: the island that the sphere's seeds put it into; itself outside of windows. */
        const val PARENT = 0

        /** Root of the island that owns the sphere, [FREE] when none does. */
        const val OWNER = 1

        /** The attempt that has a copy of the sphere, 0 when none has. Written by the owner. */
        const val ATTEMPT = 2

        /** Where in its worker's rows that copy is. Written by the owner. */
        const val PLACE = 3

        private val ENTRY: VarHandle = MethodHandles.arrayElementVarHandle(IntArray::class.java)
    }
}
