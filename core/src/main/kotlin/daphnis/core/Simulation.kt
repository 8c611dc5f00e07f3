package daphnis.core

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.Drift
import daphnis.core.force.Force
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population

/**
 * The loop: a population, boundary conditions, collisions, a list of forces and a list of outputs, carried on a step at
 * a time.
 *
 * ```
 * val simulation = Simulation(population, boundary, CollisionForcing(BridgesRestitution()), FixedTimeStep(0.1))
 * simulation.use { while (it.time < 30.0) it.advance() }
 * ```
 *
 * One step: forces act for its first half · spheres drift with every collision in time order · boundary conditions ·
 * forces act for its second half · outputs look. Not thread-safe: one thread calls; an engine may use more within
 * [advance].
 *
 * @param collisions null for spheres that pass through one another
 * @param runStart time at step 0, for a run that goes on at [startStep]; null to count back from there, with a fixed
 *   step
 * @param forces act in this order before the drift and in the reverse order after it; a [Drift] next to it
 */
public class Simulation @JvmOverloads constructor(
    public val population: Population,
    public val boundary: BoundaryConditions,
    public val collisions: CollisionForcing?,
    internal val timeStep: TimeStep,
    forces: List<Force> = emptyList(),
    outputs: List<Output> = emptyList(),
    startTime: Double = 0.0,
    startStep: Long = 0,
    runStart: Double? = null,
) : AutoCloseable {
    /**
     * Time at the end of the last step. With a fixed step it is the start plus a whole number of steps, without
     * accumulated round-off.
     */
    public var time: Double = startTime
        private set

    /** Number of steps since the start of the run, across resumes. */
    public var step: Long = startStep
        private set

    /** Time at step 0 of the run. */
    public val runStart: Double =
        runStart ?: if (timeStep is FixedTimeStep) startTime - startStep * timeStep.duration else startTime

    /**
     * The forces in the order in which they act before the drift. A [Drift] acts next to it: last before it, first
     * after it.
     */
    public val forces: List<Force> = forces.sortedBy { it is Drift }
    private val loop = ClosableLoop(collisions?.engine?.loop ?: InlineLoop, CLOSED)
    private val undo = StepUndo(population, collisions?.counters)
    private var opened = false
    private var busy = false

    private val outputs = OutputList(outputs)

    /** Whether it was given outputs of its own. */
    internal val hasOutputs: Boolean get() = !outputs.isEmpty

    init {
        require(time.isFinite()) { "start time is $startTime; it must be finite" }
        require(forces.count { it is Drift } <= 1) { "two forces want to stand for the drift; there can be one" }
        for (force in forces) force.useLoop(loop)
    }

    /**
     * Carries the simulation on by one step.
     *
     * A step is done whole or not at all. Whatever throws in it (time step, force, engine, boundary, output, an [Error]
     * too) is thrown on, and all is as it was before: population with the order of its arrays, boxes crossed, counters,
     * [time] and [step]; the record of collisions is empty. The step may then be done again, to the same bits. Outputs
     * that had seen it before another output threw are not asked again.
     *
     * @throws IllegalStateException when the state is no longer finite, after [close], and from within a step
     */
    public fun advance() {
        loop.requireOpen()
        check(!busy) { "a step is under way: advance() was called from within it" }
        open()
        undo.begin(time, step)
        busy = true
        try {
            carryOn()
            undo.commit()
        } catch (e: Throwable) {
            undo.takeBack()
            time = undo.time
            step = undo.step
            collisions?.record?.clear()
            throw e
        } finally {
            busy = false
        }
    }

    private fun carryOn() {
        val start = time
        val duration = timeStep.next(population)
        if (forces.isNotEmpty()) undo.keepVelocities()
        for (k in forces.indices) forces[k].beforeDrift(population, start, duration)
        if (collisions != null) {
            collisions.advance(population, boundary, start, duration)
        } else {
            population.drift(duration)
        }
        step++
        time = if (timeStep is FixedTimeStep) runStart + step * duration else start + duration
        applyBoundary()
        for (k in forces.indices.reversed()) forces[k].afterDrift(population, time, duration)
        checkFinite()
        outputs.write(this)
    }

    /**
     * Opens the outputs, and shows them the initial state of a simulation that starts; done by the first [advance] if
     * nobody asked before. Each is opened and sees it once, though another throws.
     */
    public fun open() {
        if (opened || busy) return
        busy = true
        try {
            outputs.open(this, if (step == 0L) Opening.START else Opening.RESUME)
            if (step == 0L) outputs.write(this)
        } finally {
            busy = false
        }
        opened = true
    }

    /** Stands at [time] after [step] steps of a run that began where this was made. To be called before all else. */
    internal fun goOnFrom(time: Double, step: Long) {
        check(!opened && this.step == 0L) { "the simulation has begun: it is at step ${this.step}" }
        this.time = time
        this.step = step
    }

    /**
     * Ends the threads of the engine and closes the outputs; from then on [advance], and loops that forces have been
     * given, throw [IllegalStateException]. A step under way, on another thread or around this call, ends well or
     * throws and is as if it had not begun; outputs are closed behind it. Closing twice is allowed.
     */
    override fun close() {
        loop.close()
        AutoCloseable { collisions?.close() }.use { outputs.close() }
    }

    private fun applyBoundary() {
        if (boundary is PerSphereBoundary) {
            loop.run(population.size) { _, from, to -> boundary.endStep(population, time, from, to) }
        } else {
            boundary.endStep(population, time)
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

    private companion object {
        const val CLOSED = "the simulation is closed"
    }
}
