package daphnis.core.cluster

import daphnis.core.cluster.bricks.BrickAhead
import daphnis.core.cluster.bricks.HaloMargins
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.engine.CollisionEngine
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.step.CollisionStep
import java.util.concurrent.Callable
import java.util.concurrent.Executors
import java.util.random.RandomGenerator

/**
 * Nodes on threads as one engine: before each step every sphere is given to any node, after it the nodes' spheres are
 * put together.
 *
 * @param perNode threads by node
 * @param ahead when bricks look ahead
 */
internal class NodesTogether(
    private val random: RandomGenerator,
    private val perNode: IntArray,
    private val ahead: BrickAhead.Choice = BrickAhead.Choice.QUICKEST,
    private val margins: () -> HaloMargins = { HaloMargins() },
) : CollisionEngine {
    override val name: String get() = "nodes"
    override val threads: Int get() = perNode.sum()
    private val pool = Executors.newFixedThreadPool(perNode.size)
    private var room = MailRoom(perNode.size)
    private var engines = engines()
    var isTrusting = false
    val redone: Long get() = engines[0].cost.redone + redoneBefore
    private var redoneBefore = 0L

    private fun engines() = List(perNode.size) {
        NodeEngine(Turns(room.mail(it)), perNode, FixedPool(perNode[it]), margins(), ahead)
    }

    override fun advance(step: CollisionStep) {
        val whole = step.population
        val holder = IntArray(whole.size) { random.nextInt(perNode.size) }
        val parts = perNode.indices.map { part(step, holder, it) }
        val ends = pool.invokeAll(perNode.indices.map { Callable { advance(it, parts[it]) } }).map { it.get() }
        check(room.unread() == 0) { "${room.unread()} messages are left" }
        val failures = ends.filterNotNull()
        if (failures.isNotEmpty()) {
            redoneBefore += engines[0].cost.redone
            engines.forEach { it.close() }
            room = MailRoom(perNode.size)
            engines = engines()
            throw failures.firstOrNull { it !is NodeFailedException } ?: failures.first()
        }
        val columns = whole.columnsToWrite(true, parts.sumOf { it.population.size })
        var at = 0
        for (part in parts) {
            val p = part.population
            PopulationColumns.joined(listOf(p)).copyInto(columns, at)
            at += p.size
        }
        whole.take(columns)
        step.counters.addParts(parts.map { it.counters })
        step.record?.let { record ->
            record.clear()
            for (part in parts) record.addAll(part.record!!, 0, part.record!!.size)
            record.sort()
        }
    }

    private fun part(step: CollisionStep, holder: IntArray, node: Int): CollisionStep {
        val whole = step.population
        val mine = holder.indices.filter { holder[it] == node }.toIntArray()
        val part = Population(PopulationColumns.picked(whole, mine), emptyList())
        return CollisionStep(part, step.boundary, step.law, CollisionCounters(), step.search).also {
            it.start = step.start
            it.duration = step.duration
            it.record = step.record?.let { CollisionRecord() }
        }
    }

    private fun advance(node: Int, step: CollisionStep): Throwable? = try {
        engines[node].crew.isTrusting = isTrusting
        engines[node].advance(step)
        null
    } catch (e: NodeFailedException) {
        e
    } catch (e: Throwable) {
        Turns(room.mail(node)).fail(e)
        e
    }

    override fun close() {
        engines.forEach { it.close() }
        pool.shutdownNow()
    }
}
