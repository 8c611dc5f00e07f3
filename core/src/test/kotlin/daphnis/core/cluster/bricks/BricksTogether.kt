package daphnis.core.cluster.bricks

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.cluster.bricks.Cuts.Companion.AXES
import daphnis.core.engine.CollisionEngine
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.parallel.ThreadHandler
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.search.GridExtent
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import kotlin.math.abs

/** All bricks of a crew in this process, as one engine, divided as somebody says. */
internal class BricksTogether(
    private val handler: ThreadHandler,
    division: BrickDivision,
    margins: HaloMargins = HaloMargins(),
    ahead: BrickAhead.Choice = BrickAhead.Choice.QUICKEST,
) : CollisionEngine {
    override val name: String get() = "bricks"
    override val threads: Int get() = handler.threads
    private val gate = ClosableLoop(ParallelLoop(handler, LoopStrategy.DYNAMIC), CollisionEngine.CLOSED)
    override val loop: RangeLoop get() = gate
    private val whole = PreparedStep()
    private val plan = ChosenTerritory(whole, margins, division)
    val crew = BrickCrew(whole, margins, ahead = ahead)
    val redone: Long get() = crew.redone
    val bricks: Int get() = crew.territory?.size ?: 1

    override fun advance(step: CollisionStep) {
        gate.requireOpen()
        whole.measure(step, loop)
        plan.prepare()
        if (crew.territory !== plan.territory) crew.settle(plan.territory)
        crew.compute(step.population.size, plan.bodies, plan.extent, loop)
        crew.collect(step.record)
        crew.store(loop)
        crew.addTo(step.counters)
    }

    override fun close() {
        gate.close()
        handler.close()
    }
}

/** The territory of a [division], chosen anew now and then, since spheres move. */
internal class ChosenTerritory(
    private val whole: PreparedStep,
    private val margins: HaloMargins,
    private val division: BrickDivision,
) {
    var bodies = Bodies()
        private set
    val extent = GridExtent()
    lateinit var territory: Territory
        private set
    private var boundary: BoundaryConditions? = null
    private var spheres = 0
    private var steps = 0

    /** Looks at the step that [whole] has measured. */
    fun prepare() {
        val population = whole.step.population
        extent.measure(population, whole.step.boundary, DoubleArray(AXES) { Double.NaN }, InlineLoop)
        extent.requireComputable(whole.reach.largestRadius)
        val mean = if (population.size == 0) 0.0 else population.radius.sum() / population.size
        bodies = bodiesOf(population, mean)
        margins.diameter = 2 * mean
        val isDue = steps++ % STEPS == 0 || boundary !== whole.step.boundary
        if (!isDue && abs(population.size - spheres) <= spheres / FEW) return
        boundary = whole.step.boundary
        spheres = population.size
        val places = CutPlaces(population, whole.step.boundary)
        val clearance = DoubleArray(AXES) { 2 * whole.reach.bound[it] + bodies.ordinary + 2 * margins.least }
        territory = Territory(places.choose(division, bodies, clearance), whole.step.boundary, steps)
    }

    private companion object {
        const val STEPS = 16
        const val FEW = 8
    }
}

/** Those of [spheres] that are much larger than the [mean]. */
internal fun bodiesOf(spheres: Population, mean: Double): Bodies {
    val large = (0 until spheres.size).filter { spheres.radius[it] > Bodies.FACTOR * mean }
    val areBodies = large.size <= Bodies.MOST
    val bodies = PopulationColumns.picked(spheres, if (areBodies) large.toIntArray() else IntArray(0))
    val others = if (areBodies) (0 until spheres.size) - large.toSet() else (0 until spheres.size).toList()
    return Bodies().also { it.take(bodies, others.maxOfOrNull { k -> spheres.radius[k] } ?: 0.0) }
}
