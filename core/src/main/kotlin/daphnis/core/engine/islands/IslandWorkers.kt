package daphnis.core.engine.islands

import daphnis.core.api.EngineApi
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.engine.islands.IslandBoard.Companion.FREE
import daphnis.core.growth.IntList
import java.util.function.IntConsumer

/**
 * The workers on one [IslandField], and what one thread alone does between their phases:
 *
 * | of a | one thread alone | all workers, side by side |
 * |---|---|---|
 * | step | [IslandField.measure] | |
 * | attempt | [IslandField.prepare], [prepare] | [IslandWorker.searchStart] |
 * | window | [openWindow] | [propose] |
 * | window | with claim rules [joinBorders] | [IslandWorker.group] |
 * | window | without them [collectRoots] | [IslandWorker.process] of every island |
 * | window | | [IslandWorker.check] |
 * | window | [mergeConflicts] | if it found any, [IslandWorker.process] and [IslandWorker.check] of those again |
 * | window | | [IslandWorker.commit] |
 * | window | | [IslandWorker.hintSuspects], unless [isLastWindow] |
 * | window | [closeWindow] | |
 * | step | [writeTo], [IslandField.store], [addTo] | |
 *
 * Between two phases is a barrier or a message. A window without potential collisions is over when it has been opened.
 * A call of the one thread out of turn throws an IllegalStateException, except that [prepare] may begin an attempt at
 * any time.
 *
 * @param size number of workers
 */
@EngineApi
public class IslandWorkers(private val field: IslandField, public val size: Int) {
    private val board = field.board
    private val workers = List(size) { IslandWorker(field, it, ::membersOf) }
    private val counted = CollisionCounters()

    private val roots = IntList()
    private val dropped = IntList()
    private var redoneInWindow = 0

    /** How long windows are; tests make them shorter and longer than is fastest. */
    internal var window = WindowLength()

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
    private var stage = Stage.UNPREPARED

    /** Whether the window at hand ends the step. */
    public val isLastWindow: Boolean get() = lastSlice == Hints.SLICES - 1

    /** How many islands are to be processed next. */
    public val rootCount: Int get() = roots.size

    /** The root of island [k] of those to be processed next. */
    public fun root(k: Int): Int = roots[k]

    public operator fun get(worker: Int): IslandWorker = workers[worker]

    private fun membersOf(worker: Int): Members = workers[worker].stores.members

    /** For a new attempt at a step, after the field was prepared. */
    public fun prepare() {
        for (worker in workers) worker.prepare()
        counted.clear()
        lastSlice = -1
        stage = Stage.BETWEEN_WINDOWS
    }

    /**
     * Opens the next window: as many slices as hold about the number of potential collisions with which islands rarely
     * grow into one another.
     *
     * @return how many potential collisions it holds at most
     */
    public fun openWindow(): Int {
        requireStage(Stage.BETWEEN_WINDOWS, "openWindow() follows prepare() or closeWindow()")
        check(!isLastWindow) { "the step has no window after the last" }
        firstSlice = lastSlice + 1
        val most = window.seeds(field.size)
        var total = 0
        var slice = firstSlice
        while (slice < Hints.SLICES) {
            var count = 0
            for (worker in workers) count += worker.stores.hints.count(slice)
            if (slice > firstSlice && total + count > most) break
            total += count
            slice++
        }
        lastSlice = slice - 1
        field.windowEnd = Hints.endOf(lastSlice, field.prepared.duration)
        board.seeds.reset(total)
        redoneInWindow = 0
        windows++
        if (total > 0) stage = Stage.PROPOSING
        return total
    }

    /** Phase of each worker: makes seeds of its own hints. */
    public fun propose(worker: Int) {
        get(worker).propose(firstSlice, lastSlice)
    }

    /**
     * Joins the islands that share a seed which no worker could make its own, and makes them the next to be processed.
     * To be called between [propose] and [IslandWorker.group], where workers use only their own spheres.
     */
    public fun joinBorders() {
        requireStage(Stage.PROPOSING, "joinBorders() follows openWindow()")
        stage = Stage.GROWING
        roots.clear()
        val seeds = board.seeds.store
        forEachBorderSeed { if (seeds.second(it) >= 0) board.union(seeds.first(it), seeds.second(it)) }
        forEachBorderSeed {
            val root = board.find(seeds.first(it))
            board.own(it, root)
            if (board.hang(it, root)) roots.add(root)
        }
    }

    private inline fun forEachBorderSeed(action: (Int) -> Unit) {
        for (worker in workers) for (s in worker.seeder.borderFrom until worker.seeder.borderTo) action(s)
    }

    /** Calls [action] with every sphere that has a seed in the island of [root], with some of them more than once. */
    public fun forEachSeeded(root: Int, action: IntConsumer) {
        val seeds = board.seeds.store
        forEachSeed(root) {
            action.accept(seeds.first(it))
            if (seeds.second(it) >= 0) action.accept(seeds.second(it))
        }
    }

    /** Time of the first seed of the island of [root]. */
    public fun startOf(root: Int): Double {
        var start = Double.POSITIVE_INFINITY
        forEachSeed(root) { start = minOf(start, board.seeds.store.time(it)) }
        return start
    }

    private inline fun forEachSeed(root: Int, action: (Int) -> Unit) {
        var s = board.firstSeed(root)
        while (s != FREE) {
            action(s)
            s = board.seeds.store.link(s)
        }
    }

    /** Makes the islands that the workers found the next to be processed. */
    public fun collectRoots() {
        requireStage(Stage.PROPOSING, "collectRoots() follows openWindow()")
        stage = Stage.GROWING
        roots.clear()
        for (worker in workers) roots.addAll(worker.seeder.roots)
    }

    /**
     * Drops the islands that touch and merges them; the merged ones are the next to be processed.
     *
     * @return false when there were none
     */
    public fun mergeConflicts(): Boolean {
        requireStage(Stage.GROWING, "mergeConflicts() follows collectRoots() or joinBorders()")
        roots.clear()
        dropped.clear()
        for (worker in workers) {
            for (k in 0 until worker.paths.count) {
                val a = worker.paths.island(k)
                val b = worker.paths.other(k)
                dropOnce(a)
                if (b == FREE) continue
                dropOnce(b)
                board.union(a, b)
            }
        }
        if (dropped.size == 0) {
            stage = Stage.COMMITTING
            return false
        }
        redoneInWindow += dropped.size
        for (k in 0 until dropped.size) giveBack(dropped[k])
        for (k in 0 until dropped.size) board.moveSeeds(dropped[k])
        for (k in 0 until dropped.size) if (board.find(dropped[k]) == dropped[k]) roots.add(dropped[k])
        for (k in 0 until roots.size) board.ownSeeded(roots[k])
        return true
    }

    private fun dropOnce(root: Int) {
        val attempt = board.attempt(root)
        val attempts = workers[board.workerOf(attempt)].stores.attempts
        val index = board.indexOf(attempt)
        if (!attempts.isAlive(index)) return
        attempts.drop(index)
        dropped.add(root)
    }

    private fun giveBack(root: Int) {
        val attempt = board.attempt(root)
        workers[board.workerOf(attempt)].grower.giveBack(board.indexOf(attempt))
    }

    /**
     * Counts the results of the window and learns how long the next one may be.
     *
     * @throws IllegalArgumentException when the step has too many collisions
     */
    public fun closeWindow() {
        requireStage(Stage.COMMITTING, "closeWindow() follows a mergeConflicts() that found none")
        var islandsInWindow = 0
        for (worker in workers) {
            worker.stores.attempts.addTo(counted)
            islandsInWindow += worker.stores.attempts.size
        }
        field.prepared.limits.checkWork(counted.collisions + counted.wallCollisions)
        islands += islandsInWindow
        redone += redoneInWindow
        window.learn(islandsInWindow, redoneInWindow)
        stage = Stage.BETWEEN_WINDOWS
    }

    /** Adds the counts of the step to [counters]. To be called last, when nothing can fail any more. */
    public fun addTo(counters: CollisionCounters) {
        requireEnd()
        counters.add(counted)
    }

    /**
     * Writes the collisions of the step to [record], in order. To be called before the population is stored, since it
     * may need memory.
     */
    public fun writeTo(record: CollisionRecord?) {
        requireEnd()
        if (record == null) return
        record.clear()
        for (worker in workers) record.addAll(worker.committer.record, 0, worker.committer.record.size)
        record.sort()
    }

    private fun requireEnd() {
        requireStage(Stage.BETWEEN_WINDOWS, "results follow closeWindow()")
        check(isLastWindow) { "results follow the last window" }
    }

    private fun requireStage(required: Stage, rule: String) {
        check(stage == required) { "the workers are at $stage: $rule" }
    }

    private enum class Stage { UNPREPARED, BETWEEN_WINDOWS, PROPOSING, GROWING, COMMITTING }
}
