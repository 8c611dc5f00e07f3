package daphnis.core.engine.bricks

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.engine.bricks.Cuts.Companion.AXES
import daphnis.core.parallel.RangeLoop
import daphnis.core.search.GridExtent
import daphnis.core.search.ImageRange
import daphnis.core.step.PreparedStep

/**
 * The bricks of one process and their agreement, driven phase by phase on the threads of a loop. A phase is a loop over
 * bricks: each takes its messages and posts others. Its end is a barrier.
 *
 * @param whole the step for all spheres
 */
internal class BrickCrew(private val whole: PreparedStep, val margins: HaloMargins) {
    private var bricks = emptyList<Brick>()
    private var nodes = emptyList<BrickNode>()
    private var boxes = Mailboxes(0)
    private var agreement = Agreement(0, margins) { _, _ -> }
    private var starts = IntArray(1)
    private val counted = CollisionCounters()
    private var steps = 0L

    /** How space is divided; null before the first [settle]. */
    var territory: Territory? = null
        private set

    /** See [BrickNode.isTrusting]. */
    var isTrusting = false

    /** Attempts since the start that were redone with wider halos. */
    var redone = 0L
        private set

    /** Spheres in halos in the last step. */
    val haloSpheres: Int get() = bricks.sumOf { it.columns.size - it.own }

    /** Divides space anew. */
    fun settle(territory: Territory) {
        val count = territory.size
        bricks = List(count) { bricks.getOrNull(it) ?: Brick() }
        boxes = Mailboxes(count)
        nodes = List(count) { BrickNode(it, territory, bricks[it], boxes.post(it)) }
        agreement = Agreement(count, margins, boxes.postBetween())
        margins.reset(count)
        starts = IntArray(count + 1)
        // Last, so that it is done again when it has failed.
        this.territory = territory
    }

    /**
     * Computes the step that [whole] has measured, writes nothing to the population.
     *
     * @param extent of all spheres
     * @param isLate whether the step is to be given up
     * @return how it ended; unless all have agreed it was given up
     */
    fun compute(bodies: Bodies, extent: GridExtent, loop: RangeLoop, isLate: () -> Boolean): End {
        val population = whole.step.population
        val halt = Halt()
        val widths = firstWidths(bodies, extent)
        val key = AttemptKey(territory!!.epoch, steps++, 0)
        val input = StepInput(key, whole, population.size, widths, halt)
        if (starts.last() != population.size) divideEvenly(population.size)
        boxes.clear()
        agreement.begin(key, widths)
        for (node in nodes) node.isTrusting = isTrusting
        each(loop, halt) { nodes[it].begin(input, Held(population, starts[it], starts[it + 1])) }
        while (true) {
            boxes.turn()
            boxes.take(BrickMessage.AGREEMENT) { agreement.receive(it) }
            if (agreement.isDone) break
            if (agreement.redone > MOST_REDOS) return End.DISAGREED
            if (isLate()) return End.LATE
            each(loop, halt) { k -> boxes.take(k) { nodes[k].receive(it) } }
        }
        redone += agreement.redone
        margins.keep(agreement.widths)
        return End.AGREED
    }

    private fun firstWidths(bodies: Bodies, extent: GridExtent): HaloWidths {
        val rounding = DoubleArray(AXES) { ImageRange.rounding(extent.from[it], extent.from[it] + extent.size[it]) }
        return HaloWidths(whole.reach.bound.copyOf(), rounding, bodies.edges(territory!!), margins.next())
    }

    /** Which brick holds which spheres at the start does not matter, only that each is held by one. */
    private fun divideEvenly(count: Int) {
        val bricks = starts.size - 1
        for (k in 0..bricks) starts[k] = (count.toLong() * k / bricks).toInt()
    }

    private inline fun each(loop: RangeLoop, halt: Halt, crossinline phase: (Int) -> Unit) {
        loop.run(bricks.size, 1) { _, from, to ->
            try {
                for (k in from until to) phase(k)
            } catch (e: Throwable) {
                // The step has failed; the work of the other threads is not needed.
                halt.isRequested = true
                throw e
            }
        }
    }

    /**
     * Collects what was counted, and what was recorded into [record], in order.
     *
     * @throws IllegalArgumentException when the step has too many collisions
     */
    fun collect(record: CollisionRecord?) {
        counted.clear()
        for (brick in bricks) counted.add(brick.counted)
        whole.limits.start(whole.step.population.size, whole.step.start)
        whole.limits.checkWork(counted.collisions + counted.wallCollisions)
        counted.redoneSteps = bricks.maxOf { it.outrun }.toLong()
        if (record == null) return
        record.clear()
        for (brick in bricks) record.addAll(brick.record, 0, brick.record.size)
        record.sort()
    }

    /** Writes all spheres to the population. When this throws, it is as it was. */
    fun store(loop: RangeLoop) {
        val population = whole.step.population
        val columns = population.columnsToWrite(whole.step.law.guard.needsLastCollision)
        var next = 0
        for (k in bricks.indices) {
            starts[k] = next
            next += bricks[k].own
        }
        starts[bricks.size] = next
        check(next == population.size) { "bricks own $next spheres of ${population.size}" }
        each(loop, Halt()) { k ->
            boxes.take(k) { nodes[k].receive(it) }
            check(nodes[k].isDone) { "brick $k has not heard of the agreement" }
            bricks[k].store(columns, starts[k])
        }
        population.take(columns)
        for (brick in bricks) brick.teach(whole)
    }

    /** Adds the counts of the step to [counters]. To be called last, when nothing can fail any more. */
    fun addTo(counters: CollisionCounters) {
        counters.add(counted)
        margins.collisionsPerSphere = 2.0 * counted.collisions / maxOf(1, whole.step.population.size)
    }

    /** How [compute] ended. */
    enum class End { AGREED, DISAGREED, LATE }

    private companion object {
        /** So many attempts fail only when halos hardly grow compared with what matters; serially it is quicker. */
        const val MOST_REDOS = 8
    }
}
