package daphnis.core.engine.islands

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.engine.islands.IslandField.Companion.FREE
import java.util.function.IntConsumer

/**
 * The workers on one [IslandField], and what is done between their phases by one thread alone. A step goes
 *
 * 1. `field.measure`, `field.prepare`, [prepare]; then *in parallel* [IslandWorker.searchStart];
 * 2. for each window: [openWindow]; *in parallel* [IslandWorker.propose]; *in parallel* [IslandWorker.group];
 *    [collectRoots]; *in parallel* [IslandWorker.process] for each of [roots]; *in parallel* [IslandWorker.check];
 *    while [mergeConflicts] finds any: process those and check again; *in parallel* [IslandWorker.commit]; *in
 *    parallel* [IslandWorker.hintSuspects] unless it was the last window; [closeWindow];
 * 3. `field.store`, [finish].
 *
 * Between any two of these stands a barrier or a message.
 *
 * @param size number of workers
 */
public class IslandCrew(private val field: IslandField, public val size: Int) {
    private val workers = arrayOfNulls<IslandWorker>(size).also { crew ->
        for (k in 0 until size) {
            crew[k] =
                IslandWorker(field, k, crew)
        }
    }
    private val counted = CollisionCounters()

    /** Roots of the islands to be processed next, the first [rootCount] entries. */
    public var roots: IntArray = IntArray(256)
        private set
    public var rootCount: Int = 0
        private set

    private var dropped = IntArray(256)
    private var droppedCount = 0
    private var share = FIRST_SHARE
    private var redoneInWindow = 0

    /** Islands processed since the start, and how many of them were dropped because they met another. */
    public var islands: Long = 0
        private set
    public var redone: Long = 0
        private set

    /** Windows since the start. */
    public var windows: Long = 0
        private set

    /** Last slice of the window at hand; −1 before the first. */
    public var lastSlice: Int = -1
        private set
    private var firstSlice = 0

    /** Whether the window at hand ends the step. */
    public val isLastWindow: Boolean get() = lastSlice == Hints.SLICES - 1

    public operator fun get(worker: Int): IslandWorker = workers[worker]!!

    /** For a new attempt at a step, after the field was prepared. */
    public fun prepare() {
        for (worker in workers) worker!!.prepare()
        counted.collisions = 0
        counted.wallCollisions = 0
        counted.guardActivations = 0
        lastSlice = -1
    }

    /**
     * Opens the next window: as many slices as hold about so many potential collisions as islands can bear without
     * growing into one another.
     *
     * @return how many potential collisions it holds at most
     */
    public fun openWindow(): Int {
        firstSlice = lastSlice + 1
        val most = maxOf(LEAST_SEEDS, (share * field.size).toInt())
        var total = 0
        var slice = firstSlice
        while (slice < Hints.SLICES) {
            var count = 0
            for (worker in workers) count += worker!!.hints.count(slice)
            if (slice > firstSlice && total + count > most) break
            total += count
            slice++
        }
        lastSlice = slice - 1
        field.windowEnd = Hints.endOf(lastSlice, field.duration)
        field.seeds.reset(total)
        redoneInWindow = 0
        windows++
        return total
    }

    /** Phase of each worker: seeds of its own hints. */
    public fun propose(worker: Int) {
        get(worker).propose(firstSlice, lastSlice)
    }

    /**
     * Joins the islands that share a seed which no worker could make its own, and puts them into [roots]. Between
     * [propose] and [IslandWorker.group], where workers keep to their own spheres.
     */
    public fun joinBorders() {
        rootCount = 0
        val seeds = field.seeds
        for (worker in workers) {
            for (s in worker!!.seeder.borderFrom until worker.seeder.borderTo) {
                if (seeds.second[s] >= 0) {
                    field.union(seeds.first[s], seeds.second[s])
                }
            }
        }
        for (worker in workers) {
            for (s in worker!!.seeder.borderFrom until worker.seeder.borderTo) {
                val root = field.find(seeds.first[s])
                own(seeds.first[s], root)
                if (seeds.second[s] >= 0) own(seeds.second[s], root)
                if (field.hang(s, root)) addRoot(root)
            }
        }
    }

    /** Calls [action] with every sphere that has a seed in the island of [root]; some more than once. */
    public fun forEachSeeded(root: Int, action: IntConsumer) {
        var s = field.seedHead[root]
        while (s != FREE) {
            action.accept(field.seeds.first[s])
            if (field.seeds.second[s] >= 0) action.accept(field.seeds.second[s])
            s = field.seeds.next[s]
        }
    }

    /** Time of the first seed of the island of [root]. */
    public fun startOf(root: Int): Double {
        var start = Double.POSITIVE_INFINITY
        var s = field.seedHead[root]
        while (s != FREE) {
            start = minOf(start, field.seeds.time[s])
            s = field.seeds.next[s]
        }
        return start
    }

    /** Puts the roots that the workers found into [roots]. */
    public fun collectRoots() {
        rootCount = 0
        for (worker in workers) {
            val count = worker!!.seeder.rootCount
            if (rootCount + count > roots.size) roots = roots.copyOf((rootCount + count) * 2)
            worker.seeder.roots.copyInto(roots, rootCount, 0, count)
            rootCount += count
        }
    }

    /**
     * Drops the islands that touch, merges them and puts the new ones into [roots].
     *
     * @return false when there were none
     */
    public fun mergeConflicts(): Boolean {
        rootCount = 0
        droppedCount = 0
        for (worker in workers) {
            for (k in 0 until worker!!.paths.count) {
                val a = worker.paths.conflicts[2 * k]
                val b = worker.paths.conflicts[2 * k + 1]
                dropOnce(a)
                if (b == FREE) continue
                dropOnce(b)
                field.union(a, b)
            }
        }
        if (droppedCount == 0) return false
        redoneInWindow += droppedCount
        for (k in 0 until droppedCount) free(dropped[k])
        for (k in 0 until droppedCount) rehang(dropped[k])
        for (k in 0 until droppedCount) if (field.find(dropped[k]) == dropped[k]) addRoot(dropped[k])
        for (k in 0 until rootCount) own(roots[k])
        return true
    }

    private fun dropOnce(root: Int) {
        val attempt = field.attempt(root)
        val attempts = get(field.workerOf(attempt)).attempts
        val index = field.indexOf(attempt)
        if (!attempts.isAlive(index)) return
        attempts.drop(index)
        if (droppedCount == dropped.size) dropped = dropped.copyOf(droppedCount * 2)
        dropped[droppedCount++] = root
    }

    private fun free(root: Int) {
        val attempt = field.attempt(root)
        get(field.workerOf(attempt)).restore(field.indexOf(attempt))
    }

    private fun rehang(root: Int) {
        val target = field.find(root)
        if (target == root) return
        var s = field.seedHead[root]
        field.seedHead[root] = FREE
        while (s != FREE) {
            val next = field.seeds.next[s]
            field.seeds.next[s] = field.seedHead[target]
            field.seedHead[target] = s
            s = next
        }
    }

    private fun own(root: Int) {
        var s = field.seedHead[root]
        while (s != FREE) {
            own(field.seeds.first[s], root)
            if (field.seeds.second[s] >= 0) own(field.seeds.second[s], root)
            s = field.seeds.next[s]
        }
    }

    private fun own(slot: Int, root: Int) {
        field.ticket[slot * IslandField.TICKET + IslandField.OWNER] = root
    }

    private fun addRoot(root: Int) {
        if (rootCount == roots.size) roots = roots.copyOf(rootCount * 2)
        roots[rootCount++] = root
    }

    /**
     * Counts what the window did and learns how long the next may be.
     *
     * @throws IllegalArgumentException when the step has too many collisions
     */
    public fun closeWindow() {
        var islandsInWindow = 0
        for (worker in workers) {
            worker!!.addTo(counted)
            islandsInWindow += worker.attempts.size
        }
        field.stepLimits.checkWork(counted.collisions + counted.wallCollisions)
        islands += islandsInWindow
        redone += redoneInWindow
        if (redoneInWindow > islandsInWindow * MOST_REDONE) {
            share = maxOf(share * 0.7, LEAST_SHARE)
        } else if (redoneInWindow < islandsInWindow * FEW_REDONE) {
            share = minOf(share * 1.1, MOST_SHARE)
        }
    }

    /** Adds what the step did to [counters]: last of all, once nothing can fail any more. */
    public fun addTo(counters: CollisionCounters) {
        counters.collisions += counted.collisions
        counters.wallCollisions += counted.wallCollisions
        counters.guardActivations += counted.guardActivations
    }

    /**
     * Writes the collisions of the step to [record], in order; before the population is stored, since it may need
     * memory.
     */
    public fun writeTo(record: CollisionRecord?) {
        if (record == null) return
        record.clear()
        for (worker in workers) record.addAll(worker!!.record, 0, worker.record.size)
        record.sort()
    }

    private companion object {
        /** Of all spheres; beyond it islands meet too many others to compare themselves with. */
        const val MOST_SHARE = 0.015
        const val FIRST_SHARE = 0.01
        const val LEAST_SHARE = 0.001
        const val LEAST_SEEDS = 16
        const val MOST_REDONE = 0.1
        const val FEW_REDONE = 0.03
    }
}
