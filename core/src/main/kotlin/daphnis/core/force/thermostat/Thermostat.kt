package daphnis.core.force.thermostat

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.force.Force
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Partition
import daphnis.core.population.Partitioned
import daphnis.core.population.Population
import daphnis.core.random.CounterRandom

/**
 * What heats and cools spheres from outside. It acts for half of each step before the drift and for half after it. The
 * numbers that it draws are functions of its seed, the id of a sphere and the time ([CounterRandom]), and its sums are
 * exact, so the state has the same bits with any engine, order of spheres, number of threads or machines, and after a
 * resume. It acts on velocities relative to the flow that the boundary drives,
 * along the axes of its space, and not on spins. It has no potential energy.
 */
public sealed class Thermostat :
    Force,
    Partitioned {
    override var partition: Partition = Partition.Whole

    /** Says to what flow velocities are relative, and along how many axes spheres move. */
    protected abstract val boundary: BoundaryConditions

    /** Spheres with this id or a higher one are left alone, such as moonlets. */
    protected abstract val firstBody: Int

    protected var loop: RangeLoop = InlineLoop
        private set

    override fun useLoop(loop: RangeLoop) {
        this.loop = loop
    }

    override fun beforeDrift(population: Population, start: Double, duration: Double): Unit =
        act(population, start, duration / 2, FIRST_HALF)

    override fun afterDrift(population: Population, end: Double, duration: Double): Unit =
        act(population, end, duration / 2, SECOND_HALF)

    /** Acts for [duration] at [time]; [half] tells the end of a step from the start of the next at the same time. */
    internal abstract fun act(population: Population, time: Double, duration: Double, half: Int)

    override fun potentialEnergy(population: Population, boundary: BoundaryConditions, time: Double): Double = 0.0

    internal fun isBody(id: Int): Boolean = id >= firstBody && firstBody != Int.MAX_VALUE

    /** Number of axes along which spheres move. */
    internal val axes: Int get() = boundary.space.dimensions

    /** Velocity of the flow along [axis] where the sphere at index [k] is. */
    internal fun flowAt(population: Population, k: Int, axis: Int): Double {
        val flow = boundary.meanFlow ?: return 0.0
        return if (axis == flow.flowAxis) flow.rate * population.position(flow.normalAxis)[k] else 0.0
    }

    internal companion object {
        const val FIRST_HALF = 0
        const val SECOND_HALF = 1
    }
}
