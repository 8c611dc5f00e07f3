package daphnis.core.cluster

import daphnis.core.cluster.bricks.BrickAhead
import daphnis.core.cluster.bricks.BrickCrew
import daphnis.core.cluster.bricks.HaloMargins
import daphnis.core.engine.CollisionEngine
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.parallel.ThreadHandler
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep

/**
 * Collisions of the spheres that the nodes of a crew hold together. Each node advances its own population, at the same
 * time as the others, and afterwards it holds the spheres that are in its territory. [BrickCrew] says why bricks give the
 * serial engine's bits.
 *
 * A node cannot leave a step to the serial engine, since it does not hold all spheres. Where bricks do not come to
 * agree, or a guess ends with an exception, they compute the step once more with all spheres in every halo. That is the
 * serial engine's computation, so its exception is the step's.
 *
 * @param threads by rank
 * @param ahead when bricks look ahead
 */
internal class NodeEngine(
    private val turns: Turns,
    threads: IntArray,
    private val handler: ThreadHandler,
    private val margins: HaloMargins = HaloMargins(),
    ahead: BrickAhead.Choice = BrickAhead.Choice.QUICKEST,
) : CollisionEngine {
    override val name: String get() = "node"
    override val threads: Int get() = handler.threads
    private val gate = ClosableLoop(ParallelLoop(handler, LoopStrategy.DYNAMIC), CollisionEngine.CLOSED)
    override val loop: RangeLoop get() = gate

    private val whole = PreparedStep()
    private val places = RemoteBricks(turns, threads)
    internal val crew = BrickCrew(whole, margins, places, ahead)
    private val plan = NodePlan(turns, whole, margins, threads)

    /** Number of spheres of all nodes in the last step. */
    var total = 0
        private set

    /** What bricks have cost since the start. */
    val cost: NodeCost get() = NodeCost(crew.redone, crew.haloSpheres, turns.bytesSent)

    override fun advance(step: CollisionStep) {
        gate.requireOpen()
        whole.measure(step, loop) { bounds ->
            val all = turns.gather(bounds.numbers() + step.population.size.toDouble())
            bounds.take(DoubleArray(all[0].size - 1) { k -> all.maxOf { it[k] } })
            val size = all.sumOf { it.last().toLong() }
            require(size <= Int.MAX_VALUE) { "$size spheres; ${Int.MAX_VALUE} are possible" }
            total = size.toInt()
        }
        plan.prepare(step.population, step.boundary, crew.busy)
        if (crew.territory !== plan.territory) crew.settle(plan.territory)
        crew.compute(total, plan.bodies, plan.extent, loop)
        crew.collect(step.record)
        crew.store(loop)
        crew.addTo(step.counters)
    }

    override fun close() {
        gate.close()
        handler.close()
    }
}
