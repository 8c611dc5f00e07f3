package daphnis.core

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.Drift
import daphnis.core.force.Force
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population

/**
 * The loop: a population, boundary conditions, collisions, a list of forces and a list of outputs, carried on a step at a time.
 *
 * ```
 * val simulation = Simulation(population, boundary, CollisionForcing(BridgesRestitution()), FixedTimeStep(0.1))
 * simulation.use { while (it.time < 30.0) it.advance() }
 * ```
 *
 * One step: forces act for its first half · spheres drift with every collision in time order · boundary conditions ·
 * forces act for its second half · outputs look. Not thread-safe: one thread calls; an engine may use more within [advance].
 *
 * @param collisions null for spheres that pass through one another
 * @param runStart time at step 0, for a run that goes on at [startStep]; null to count back from there, with a fixed step
 * @param forces act in this order before the drift and in the reverse order after it; a [Drift] next to it
 */
public class Simulation(
    public val population: Population,
    public val boundary: BoundaryConditions,
    public val collisions: CollisionForcing?,
    private val timeStep: TimeStep,
    forces: List<Force> = emptyList(),
    private val outputs: List<Output> = emptyList(),
    startTime: Double = 0.0,
    startStep: Long = 0,
    runStart: Double? = null,
) : AutoCloseable {
    /** Time at the end of the last step. With a fixed step it is the start plus a whole number of steps, without accumulated round-off. */
    public var time: Double = startTime
        private set

    /** Number of steps since the start of the run, across resumes. */
    public var step: Long = startStep
        private set

    /** Time at step 0 of the run. */
    public val runStart: Double = runStart ?: if (timeStep is FixedTimeStep) startTime - startStep * timeStep.duration else startTime

    /**
     * The forces in the order in which they act before the drift. A [Drift] acts next to it: last before it, first
     * after it.
     */
    public val forces: List<Force> = forces.sortedBy { it is Drift }
    private val loop = collisions?.engine?.loop ?: InlineLoop
    private val velocities = KeptVelocities()
    private var opened = false

    init {
        require(time.isFinite()) { "start time is $startTime; it must be finite" }
        require(forces.count { it is Drift } <= 1) { "two forces want to stand for the drift; there can be one" }
        for (force in forces) force.useLoop(loop)
    }

    /**
     * Carries the simulation on by one step.
     *
     * When the drift with its collisions fails, what it threw is thrown on and the population is as it was before the step.
     *
     * @throws IllegalStateException when the state is no longer finite
     */
    public fun advance() {
        open()
        val start = time
        val duration = timeStep.next(population)
        if (forces.isNotEmpty()) velocities.keep(population)
        for (k in forces.indices) forces[k].beforeDrift(population, start, duration)
        try {
            if (collisions != null) collisions.advance(population, boundary, start, duration) else drift(duration)
        } catch (e: Throwable) {
            // The engine leaves the population as it got it; the kicks have to be taken back.
            if (forces.isNotEmpty()) velocities.restore(population)
            throw e
        }
        step++
        time = if (timeStep is FixedTimeStep) runStart + step * duration else start + duration
        applyBoundary()
        for (k in forces.indices.reversed()) forces[k].afterDrift(population, time, duration)
        checkFinite()
        for (k in outputs.indices) outputs[k].write(this)
    }

    /** Shows the initial state to the outputs; done by the first [advance] if nobody asked before. */
    public fun open() {
        if (opened) return
        opened = true
        if (step == 0L) for (k in outputs.indices) outputs[k].write(this)
    }

    /** Ends the threads of the engine. */
    override fun close() {
        collisions?.close()
    }

    private fun applyBoundary() {
        if (boundary is PerSphereBoundary) {
            loop.run(population.size) { _, from, to -> boundary.endStep(population, time, from, to) }
        } else {
            boundary.endStep(population, time)
        }
    }

    private fun drift(duration: Double) {
        val p = population
        for (k in 0 until p.size) {
            p.x[k] += p.vx[k] * duration
            p.y[k] += p.vy[k] * duration
            p.z[k] += p.vz[k] * duration
        }
    }

    /** One sum over everything is NaN or infinite as soon as one number is; cheap against a step. */
    private fun checkFinite() {
        val p = population
        loop.run(p.size) { _, from, to ->
            var sum = 0.0
            for (k in from until to) sum += (p.x[k] + p.y[k] + p.z[k] + p.vx[k] + p.vy[k] + p.vz[k]) * 0.0
            check(sum == 0.0) { "the state is no longer finite after step $step at time $time" }
        }
    }
}

/** The velocities of a population before its forces acted. */
private class KeptVelocities {
    private var x = DoubleArray(0)
    private var y = DoubleArray(0)
    private var z = DoubleArray(0)

    fun keep(population: Population) {
        x = copy(population.vx, x)
        y = copy(population.vy, y)
        z = copy(population.vz, z)
    }

    fun restore(population: Population) {
        x.copyInto(population.vx)
        y.copyInto(population.vy)
        z.copyInto(population.vz)
    }

    private fun copy(from: DoubleArray, into: DoubleArray): DoubleArray = if (into.size == from.size) from.copyInto(into) else from.copyOf()
}
