package daphnis.core.cluster.bricks

import daphnis.core.boundary.approachAlong
import daphnis.core.cluster.bricks.Cuts.Companion.AXES
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.parallel.RangeLoop
import daphnis.core.search.GridExtent
import daphnis.core.search.ImageRange
import daphnis.core.step.PreparedStep
import kotlin.math.abs

/**
 * The bricks of one process and their agreement, driven phase by phase on the threads of a loop. A phase is a loop over
 * bricks: each takes its messages and posts others. Its end is a barrier, also for the processes that have the other
 * bricks, if there are any.
 *
 * A brick owns the spheres of a part of space, and computes whole steps of them in memory of its own. It shares nothing
 * with others until the step is done. Around its territory it has a halo of its neighbours' spheres, which it computes
 * too. At the end neighbours compare the paths that both have computed. Where they differ, the halo was too narrow, and
 * the brick computes the step again with a wider one.
 *
 * ```
 *      territory of A          │          territory of B
 *                     ┌────────┼────────┐
 *    ○   ○    ○   ○   │ ○    ○ │ ●    ● │  ○    ○   ○   ○
 *                     │        │ in sight of A          ●  copies that A computes too
 *      ○    ○   ○     │  ○   ○ │ ●   ●  │   ●    ●  │  ○
 *                     │        │        │  room for │
 *    ○    ○   ○   ○   │○    ○  │  ●   ● │  chains ● │ ○   ○
 *                     └────────┼────────┘
 * ```
 *
 * **Same bits.** Let P(q) be the path of sphere q that its owner has computed. Suppose that, for every brick n at once,
 * n has computed P(q) for all q in its sight, which is everything that a sphere of the territory could touch within the
 * bounds of the step. Then {P} is the serial engine's step. Otherwise take its first collision, p with q, that {P}
 * lacks or has otherwise; up to then the paths of both are right in {P}. If one brick owns both, its own computation
 * would have found the collision. If p's owner n does not own q, then q is in the sight of n, so n has worked with P(q)
 * and would have found it. A collision that only {P} has fails in the same way. "At once" takes one agreement of all
 * bricks: one that computes again may change a path that was compared before. Copies keep the coordinates and images of
 * the whole box, so they are rounded as in the serial engine. How a brick finds its collisions does not matter, as long
 * as it finds all of the spheres that it was given ([Brick]).
 *
 * So exactness does not rest on the width of the halo, which is a guess; that only decides how often bricks compute
 * again ([HaloMargins]). A guess may end with an exception, though, and bricks may not come to agree. Then all compute
 * all spheres, as the serial engine does, so what that ends with is the step's; it is counted in `causalityReplays`.
 *
 * What a brick does is a state machine, [BrickNode], which knows neither threads nor where the others are.
 *
 * @param whole the step for the spheres of this process, measured for all
 * @param places which bricks are here
 * @param ahead when bricks look ahead
 */
internal class BrickCrew(
    private val whole: PreparedStep,
    val margins: HaloMargins,
    private val places: BrickPlaces = BrickPlaces.Here,
    private val ahead: BrickAhead.Choice = BrickAhead.Choice.QUICKEST,
) {
    private var bricks = emptyList<Brick>()
    private var nodes = emptyList<BrickNode>()
    private var boxes = Mailboxes(0)
    private var agreement = Agreement(0, margins) { _, _ -> }

    /** Number of the first brick here. */
    private var first = 0
    private var starts = IntArray(1)
    private val counted = CollisionCounters()
    private var steps = 0L

    /** How space is divided; null before the first [settle]. */
    var territory: Territory? = null
        private set

    /** See [BrickNode.isTrusting]. */
    var isTrusting = false

    /** What all bricks have counted in the last step. */
    val counts: BrickCounts get() = agreement.counts

    /** Steps of single bricks that were taken in epochs, since the territory is divided as it is. */
    val stepsAhead: Long get() = bricks.sumOf { it.stepsAhead }

    /** Attempts since the start that were redone with wider halos. */
    var redone = 0L
        private set

    /** Seconds since the start in which bricks here were computed, without waiting for those elsewhere. */
    var busy = 0.0
        private set

    /** Spheres in halos in the last step. */
    val haloSpheres: Int get() = bricks.sumOf { it.spheres.near.size }

    /** Divides space anew. */
    fun settle(territory: Territory) {
        val all = territory.size
        first = places.from(all)
        val count = places.to(all) - first
        bricks = List(count) { bricks.getOrNull(it) ?: Brick(ahead) }
        boxes = Mailboxes(all)
        nodes = List(count) { BrickNode(first + it, territory, bricks[it], boxes.post(first + it)) }
        val post = boxes.postBetween()
        agreement =
            Agreement(all, margins) { to, message -> if (to - first in 0 until count) post.send(to, message) }
        margins.reset(all)
        starts = IntArray(count + 1)
        // Last, so that it is done again when it has failed.
        this.territory = territory
    }

    /**
     * Computes the step that [whole] has measured, writes nothing to the population.
     *
     * @param total number of all spheres
     * @param extent of all spheres
     * @throws RuntimeException what the serial engine throws, such as when the step has too many collisions
     */
    fun compute(total: Int, bodies: Bodies, extent: GridExtent, loop: RangeLoop) {
        val population = whole.step.population
        val halt = Halt()
        val widths = firstWidths(bodies, extent)
        val key = AttemptKey(territory!!.epoch, steps++, 0)
        val input = StepInput(key, whole, total, widths, halt)
        if (starts.last() != population.size) divideEvenly(population.size)
        agreement.begin(key, widths)
        for (node in nodes) node.isTrusting = isTrusting
        each(loop, halt) { nodes[it].begin(input, Held(population, starts[it], starts[it + 1])) }
        while (true) {
            boxes.turn()
            places.carry(boxes)
            boxes.take(BrickMessage.AGREEMENT) { agreement.receive(it) }
            if (agreement.isDone) break
            if (agreement.hasFailed) throw nodes.firstNotNullOfOrNull { it.failure } ?: FailedElsewhereException()
            each(loop, halt) { k -> boxes.take(first + k) { nodes[k].receive(it) } }
        }
        checkCounts(total)
        redone += agreement.redone
        if (!agreement.widths.isEverything) margins.keep(agreement.widths)
    }

    private fun firstWidths(bodies: Bodies, extent: GridExtent): HaloWidths {
        val boundary = whole.step.boundary
        val room = DoubleArray(AXES) {
            val rounding = ImageRange.rounding(extent.from[it], extent.from[it] + extent.size[it]) + whole.beyondContact
            val approached = abs(boundary.approachAlong(it)) * whole.duration
            if (boundary.hasImages(it)) rounding + approached * boundary.box.length(it) else rounding
        }
        return HaloWidths(whole.reach.bound.copyOf(), room, bodies.edges(territory!!), margins.next())
    }

    /** Which brick holds which spheres at the start does not matter, only that each is held by one. */
    private fun divideEvenly(count: Int) {
        val bricks = starts.size - 1
        for (k in 0..bricks) starts[k] = (count.toLong() * k / bricks).toInt()
    }

    private inline fun each(loop: RangeLoop, halt: Halt, crossinline phase: (Int) -> Unit) {
        val begin = System.nanoTime()
        loop.run(bricks.size, 1) { _, from, to ->
            try {
                for (k in from until to) phase(k)
            } catch (e: Throwable) {
                // The step has failed; the work of the other threads is not needed.
                halt.isRequested = true
                throw e
            }
        }
        busy += (System.nanoTime() - begin) * 1e-9
    }

    /** Collects what was counted here, and what was recorded into [record], in order. */
    fun collect(record: CollisionRecord?) {
        counted.clear()
        for (brick in bricks) counted.add(brick.counted)
        counted.redoneSteps = bricks.maxOfOrNull { it.outrun }?.toLong() ?: 0
        if (record == null) return
        record.clear()
        for (brick in bricks) record.addAll(brick.record, 0, brick.record.size)
        record.sort()
    }

    /**
     * Checks what all bricks have counted.
     *
     * @throws IllegalArgumentException when the step has too many collisions
     */
    private fun checkCounts(total: Int) {
        whole.limits.start(total, whole.step.start)
        whole.limits.checkWork(counts.collisions + counts.wallCollisions)
        check(counts.spheres == total.toLong()) { "bricks own ${counts.spheres} spheres of $total" }
    }

    /** Writes the spheres of the bricks here to the population. When this throws, it is as it was. */
    fun store(loop: RangeLoop) {
        val population = whole.step.population
        var next = 0
        for (k in bricks.indices) {
            starts[k] = next
            next += bricks[k].spheres.own
        }
        starts[bricks.size] = next
        val columns = population.columnsToWrite(whole.step.law.guard.needsLastCollision, next)
        each(loop, Halt()) { k ->
            boxes.take(first + k) { nodes[k].receive(it) }
            check(nodes[k].isDone) { "brick ${first + k} has not heard of the agreement" }
            bricks[k].store(columns, starts[k])
        }
        population.take(columns)
        for (brick in bricks) brick.teach(whole)
    }

    /**
     * Adds the counts of the step here to [counters]. To be called last, when nothing can fail any more.
     */
    fun addTo(counters: CollisionCounters) {
        counters.add(counted)
        if (agreement.widths.isEverything) counters.causalityReplays++
        margins.collisionsPerSphere = 2.0 * counts.collisions / maxOf(1L, counts.spheres)
    }
}

/** A step has ended with an exception in all processes; this one has no brick that could tell which. */
internal class FailedElsewhereException : RuntimeException("the step has failed on another node")
