package daphnis.core.engine

import daphnis.core.collision.StepRows
import daphnis.core.collision.WallContact
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.queue.BucketEventQueue
import daphnis.core.queue.EventQueue
import daphnis.core.search.Grid
import daphnis.core.search.Reach
import daphnis.core.search.RowBounds

/**
 * The specification: section 2 of Lewis & Massingill on one thread.
 *
 * 1. Bound how far anybody can go in the step, build a grid for that bound, copy the spheres in cell order.
 * 2. Queue every potential collision of the step.
 * 3. Take the earliest. Bring its two spheres, and nobody else, to the moment of contact and change their velocities.
 *    Drop what the two had queued; find and queue what they can now hit. Repeat until the queue is empty.
 * 4. Bring every sphere to the end of the step.
 *
 * **No contact is missed.** The grid finds every pair that can touch as long as nobody goes farther from where it
 * started than the bound. Paths between collisions are straight, so it is enough to look, after each collision, at
 * where the sphere would be at the end of the step. When that is beyond the bound, the step is abandoned, the bound
 * enlarged and the step redone from the population, which has not been written yet.
 *
 * **When a step fails** is part of the specification too: a collapse, too many collisions ([StepLimits]) and images too
 * far away ([Reach]) are noticed at the first collision, in order of time, at which they hold, by what belongs to the
 * trajectory alone. Engines that guess put what fails them before this one.
 *
 * **Time order.** Events leave the queue in order, and a collision at t queues events at t or later, so every sphere
 * sees its collisions in order of time. An event whose spheres have changed since it was queued was dropped with them.
 */
public class SerialEngine(private val queue: EventQueue = BucketEventQueue()) : CollisionEngine {
    override val name: String get() = "serial"
    override val threads: Int get() = 1
    private val gate = ClosableLoop(InlineLoop, CollisionEngine.CLOSED)
    override val loop: RangeLoop get() = gate

    private val grid = Grid()
    private val rows = StepRows()
    private val reach = Reach()
    private val walls = WallContact()
    private val bounds = RowBounds()
    private val search = NeighbourSearch(rows, grid, queue, bounds)
    private val limits = StepLimits()

    // Counted within the step, added to the run's counters once it has succeeded.
    private var collisions = 0L
    private var wallCollisions = 0L
    private var guarded = 0L

    override fun advance(step: CollisionStep) {
        gate.requireOpen()
        reach.measure(step.population, step.boundary, step.duration)
        walls.prepare(step.boundary)
        var redone = 0
        while (!attempt(step)) redone++
        step.record?.sort()
        rows.store(step.population, step.duration)
        step.counters.collisions += collisions
        step.counters.wallCollisions += wallCollisions
        step.counters.guardActivations += guarded
        step.counters.redoneSteps += redone
    }

    /** @return false when somebody outran the bound, which is now larger */
    private fun attempt(step: CollisionStep): Boolean {
        val population = step.population
        collisions = 0
        wallCollisions = 0
        guarded = 0
        step.record?.clear()
        grid.build(population, step.boundary, step.start, step.duration, reach.bound, structure = step.search)
        rows.load(population, grid.order, step.duration, step.law.guard.needsLastCollision)
        bounds.measure(grid, rows, step.duration, InlineLoop)
        queue.reset(step.duration, rows.id, rows.size)
        search.prepare(step.duration)
        limits.start(rows.size, step.start)
        search.queueStart()
        if (walls.present) for (slot in 0 until rows.size) queueWalls(slot, step.duration)
        while (queue.pop()) if (!process(step)) return false
        return true
    }

    /** @return false when one of the two outran the bound, which is now larger */
    private fun process(step: CollisionStep): Boolean {
        val time = queue.time
        val first = queue.first
        val second = queue.second
        if (second < 0) {
            walls.reflect(rows, first, WallContact.face(second), time)
            wallCollisions++
            queue.removeAllOf(first)
            if (!isAllowed(step, first, second, time)) return false
            requeue(step, first, time, NOBODY)
            return true
        }
        val law = step.law
        if (law.collide(rows, first, second, queue.image, grid.images, time)) {
            collisions++
            if (law.guarded) guarded++
            step.record?.add(time, rows.id[first], rows.id[second], law)
        }
        // The pair itself is searched once, from the first; the second leaves it out.
        queue.removeAllOf(first)
        queue.removeAllOf(second)
        if (!isAllowed(step, first, second, time)) return false
        requeue(step, first, time, NOBODY)
        requeue(step, second, time, first)
        return true
    }

    /** @return false when one of the two outran the bound, which is now larger */
    private fun isAllowed(step: CollisionStep, first: Int, second: Int, time: Double): Boolean {
        limits.checkProgress(rows, first, second, time)
        limits.checkWork(collisions + wallCollisions)
        val population = step.population
        val duration = step.duration
        val isOutrun = reach.isOutrun(rows, first, population, duration) ||
            second >= 0 &&
            reach.isOutrun(rows, second, population, duration)
        if (!isOutrun) return true
        reach.enlarge(rows, first, second, population, duration)
        return false
    }

    private fun requeue(step: CollisionStep, slot: Int, time: Double, except: Int) {
        bounds.include(slot, rows, slot)
        search.queueAll(slot, time, except)
        if (walls.present) queueWalls(slot, step.duration)
    }

    private fun queueWalls(slot: Int, duration: Double) {
        for (face in 0 until WallContact.FACES) {
            val t = walls.time(rows, slot, face)
            if (t <= duration) queue.add(t, slot, WallContact.partner(face), 0)
        }
    }

    override fun close() {
        gate.close()
    }

    private companion object {
        const val NOBODY = -1
    }
}
