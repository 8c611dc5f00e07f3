package daphnis.core.engine

import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.queue.BucketEventQueue
import daphnis.core.queue.EventQueue
import daphnis.core.step.CollisionStep
import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep
import daphnis.core.step.StepLimits

/**
 * The specification: section 2 of Lewis & Massingill on one thread.
 *
 * 1. Bound how far any sphere can go in the step, build a grid for that bound, and copy the spheres in cell order.
 * 2. Queue every potential collision of the step.
 * 3. Take the earliest. Move its two spheres, and no other sphere, to the moment of contact and change their
 *    velocities. Drop what the two had queued; find and queue what they can now hit. Repeat until the queue is empty.
 * 4. Move every sphere to the end of the step.
 *
 * **No contact is missed.** The grid finds every pair that can touch as long as no sphere goes farther from where it
 * started than the bound. Paths between collisions are straight, so it is enough to look, after each collision, at
 * where the sphere would be at the end of the step. When that is beyond the bound, the step is abandoned, the bound is
 * enlarged, and the step is redone from the population, which has not been written yet.
 *
 * **When a step fails** is part of the specification too. A collapse, too many collisions ([StepLimits]) and images too
 * far away ([Reach]) are noticed at the first collision, in time order, at which they hold, and from the trajectory
 * alone. Engines that guess pass a step in which their guess failed to this engine.
 *
 * **Time order.** Events leave the queue in order, and a collision at t queues events at t or later, so every sphere
 * has its collisions in time order. An event is dropped as soon as one of its spheres changes.
 *
 * @param prepared the structures in which the step is prepared; an engine which falls back to this one shares its own
 */
public class SerialEngine @JvmOverloads constructor(
    private val queue: EventQueue = BucketEventQueue(),
    private val prepared: PreparedStep = PreparedStep(),
) : CollisionEngine {
    override val name: String get() = "serial"
    override val threads: Int get() = 1
    private val gate = ClosableLoop(InlineLoop, CollisionEngine.CLOSED)
    override val loop: RangeLoop get() = gate
    private val impact = Impact(prepared, prepared.rows, queue)

    override fun advance(step: CollisionStep) {
        gate.requireOpen()
        prepared.measure(step)
        var redone = 0
        while (!attempt(step)) redone++
        step.record?.sort()
        prepared.store()
        // Counted within the step, and added only now that the step has succeeded.
        step.counters.add(impact.counted)
        step.counters.redoneSteps += redone
    }

    /** @return false when a sphere went beyond the bound, which is now larger */
    private fun attempt(step: CollisionStep): Boolean {
        prepared.prepare()
        val rows = prepared.rows
        queue.reset(step.duration, rows.id, rows.size)
        impact.begin(step.record)
        impact.candidates.start(0, rows.size, queue)
        while (queue.pop()) {
            val end = impact.process(queue.time, queue.first, queue.second, queue.image)
            if (end == Impact.End.DONE) continue
            prepared.enlarge(rows, queue.first, queue.second)
            return false
        }
        return true
    }

    override fun close() {
        gate.close()
    }
}
