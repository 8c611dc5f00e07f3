package daphnis.core.engine.islands

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.UNKNOWN
import daphnis.core.queue.EventStore
import java.lang.invoke.MethodHandles
import java.lang.invoke.VarHandle

/**
 * Which island every sphere belongs to in a window: the part of [IslandField] that workers write side by side. The
 * methods stand in the order of the phases that call them.
 *
 * | phase | calls | which threads may |
 * |---|---|---|
 * | propose | [union] | any worker, for any spheres |
 * | group | [own], [hang] | the worker with the seed |
 * | grow | [claim] | any worker, for any sphere: one succeeds |
 * | grow | [take], [announce], [giveBack] | the worker that grows the island which owns the sphere |
 * | check | [owner], [attempt], [place] | any worker; none writes |
 * | merge | [giveBack], [union], [moveSeeds], [ownSeeded] | one thread alone |
 * | commit | [release] | the worker whose attempt has the sphere |
 *
 * Ownership is asserted, which costs nothing where assertions are off.
 *
 * @param rows the state at the start of the window; the board writes local times only
 */
internal class IslandBoard(private val rows: StepRows, private val workers: Int) {
    /** The seeds of the window. */
    val seeds = Seeds()

    /** Four numbers per slot: [PARENT], [OWNER], [ATTEMPT], [PLACE]. */
    private var columns = IntArray(0)

    /** First seed of the island with this root, [FREE] when there is none. */
    private var seedHead = IntArray(0)

    /** Whether no sphere belongs to an island. */
    private var isClean = false

    /** Makes room for [size] slots, none of which belongs to an island. One thread alone. */
    fun prepare(size: Int) {
        if (seedHead.size < size) {
            columns = IntArray(size * WIDTH)
            seedHead = IntArray(size)
            isClean = false
        }
        if (!isClean) for (slot in seedHead.indices) clear(slot)
        isClean = false
    }

    /** Notes that all islands were committed, so that the next [prepare] finds all slots free. */
    fun leaveClean() {
        isClean = true
    }

    /** The root of the island into which its seeds put [slot]; [slot] itself when it has none. */
    fun find(slot: Int): Int {
        var k = slot
        while (true) {
            val p = columns[k * WIDTH + PARENT]
            if (p == k) return k
            val q = columns[p * WIDTH + PARENT]
            // A parent is only ever replaced by one of its ancestors, so writes of several workers do no harm.
            if (q != p) columns[k * WIDTH + PARENT] = q
            k = q
        }
    }

    /** Joins the islands of two spheres. Any number of workers at once. */
    fun union(a: Int, b: Int) {
        while (true) {
            val p = find(a)
            val q = find(b)
            if (p == q) return
            val low = minOf(p, q)
            val high = maxOf(p, q)
            if (ENTRY.compareAndSet(columns, high * WIDTH + PARENT, high, low)) return
        }
    }

    /** Gives the spheres of [seed] to the island of [root], into which the unions have put them. */
    fun own(seed: Int, root: Int) {
        own(seeds.store.first(seed), root, seeds.store.second(seed))
    }

    private fun own(first: Int, root: Int, second: Int) {
        assert(find(first) == root && (second < 0 || find(second) == root)) { "slots $first, $second are not of $root" }
        columns[first * WIDTH + OWNER] = root
        if (second >= 0) columns[second * WIDTH + OWNER] = root
    }

    /** Hangs [seed] into the list of [root]; true for the first one. Any number of workers at once. */
    fun hang(seed: Int, root: Int): Boolean {
        assert(find(root) == root) { "slot $root is not a root" }
        val before = ENTRY.getAndSet(seedHead, root, seed) as Int
        seeds.store.link(seed, before)
        return before == FREE
    }

    /** First seed of the island of [root], [FREE] when there is none; [EventStore.link] leads to the next. */
    fun firstSeed(root: Int): Int = seedHead[root]

    /**
     * Takes a sphere that belongs to no island for the island of [root]; false when another island was quicker. Any
     * number of workers at once.
     */
    fun claim(slot: Int, root: Int): Boolean = ENTRY.compareAndSet(columns, slot * WIDTH + OWNER, FREE, root)

    /**
     * Notes that the island of [root] has its copy of [slot] at [place] of the rows of [attempt]. From then on the
     * sphere's local time is [UNKNOWN], which tells other workers that they cannot know where it is.
     */
    fun take(slot: Int, root: Int, attempt: Int, place: Int) {
        assert(owner(slot) == root) { "slot $slot is owned by ${owner(slot)}, not by $root" }
        rows.state[slot * STRIDE + TIME] = UNKNOWN
        columns[slot * WIDTH + ATTEMPT] = attempt
        columns[slot * WIDTH + PLACE] = place
    }

    /**
     * A full fence: what the caller reads of other islands from here on is not older than what it has written. Of two
     * islands that mark their spheres, announce them and then search, at least one sees the mark of the other.
     */
    fun announce() {
        VarHandle.fullFence()
    }

    /** Undoes the taking of [slot], which had local time [time]. */
    fun giveBack(slot: Int, time: Double) {
        assert(attempt(slot) != 0) { "slot $slot was not taken" }
        rows.state[slot * STRIDE + TIME] = time
        // A sphere which has seeds stays claimed, for the next attempt.
        if (!isSeeded(slot)) columns[slot * WIDTH + OWNER] = FREE
        columns[slot * WIDTH + ATTEMPT] = 0
    }

    private fun isSeeded(slot: Int): Boolean = seedHead[slot] != FREE || columns[slot * WIDTH + PARENT] != slot

    /** Root of the island that owns [slot], [FREE] when none does. */
    fun owner(slot: Int): Int = columns[slot * WIDTH + OWNER]

    /** The attempt that has a copy of [slot], 0 when none has. */
    fun attempt(slot: Int): Int = columns[slot * WIDTH + ATTEMPT]

    /** The place of the copy of [slot] in the rows of its attempt's worker. */
    fun place(slot: Int): Int = columns[slot * WIDTH + PLACE]

    /** Hangs the seeds of [from], which is no longer a root, into the list of the root that it has now. */
    fun moveSeeds(from: Int) {
        val to = find(from)
        if (to == from) return
        val store = seeds.store
        var s = seedHead[from]
        seedHead[from] = FREE
        while (s != FREE) {
            val next = store.link(s)
            store.link(s, seedHead[to])
            seedHead[to] = s
            s = next
        }
    }

    /** Gives every sphere that has a seed in the list of [root] to its island. */
    fun ownSeeded(root: Int) {
        var s = seedHead[root]
        while (s != FREE) {
            own(s, root)
            s = seeds.store.link(s)
        }
    }

    /** Makes [slot], of which [worker] has a copy, a sphere that belongs to no island and has no seeds. */
    fun release(slot: Int, worker: Int) {
        assert(workerOf(attempt(slot)) == worker) { "slot $slot is with worker ${workerOf(attempt(slot))}" }
        clear(slot)
    }

    private fun clear(slot: Int) {
        val p = slot * WIDTH
        columns[p + PARENT] = slot
        columns[p + OWNER] = FREE
        columns[p + ATTEMPT] = 0
        columns[p + PLACE] = FREE
        seedHead[slot] = FREE
    }

    /** The number of the attempt that is number [index] of [worker]; > 0. */
    fun attemptNumber(worker: Int, index: Int): Int = index * workers + worker + 1

    /** The worker that made [attempt]. */
    fun workerOf(attempt: Int): Int = (attempt - 1) % workers

    /** Which of its worker's attempts [attempt] is. */
    fun indexOf(attempt: Int): Int = (attempt - 1) / workers

    companion object {
        /** No island, no seed, no sphere. */
        const val FREE = -1

        private const val WIDTH = 4

        /** Union-find: the island into which the sphere's seeds put it; the sphere itself outside of windows. */
        private const val PARENT = 0

        /** Root of the island that owns the sphere. */
        private const val OWNER = 1

        /** The attempt that has a copy of the sphere. */
        private const val ATTEMPT = 2

        /** The place of that copy in its worker's rows. */
        private const val PLACE = 3

        private val ENTRY: VarHandle = MethodHandles.arrayElementVarHandle(IntArray::class.java)
    }
}
