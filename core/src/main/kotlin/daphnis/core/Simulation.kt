package daphnis.core

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.Workforce
import daphnis.core.force.Drift
import daphnis.core.force.Force
import daphnis.core.force.PairEnergy
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Conserved
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.source.Sources

/**
 * The loop: a population, boundary conditions, collisions, a list of forces and a list of outputs, advanced one step at
 * a time.
 *
 * ```
 * val simulation = Simulation(population, boundary, CollisionForcing(BridgesRestitution()), FixedTimeStep(0.1))
 * simulation.use { while (it.time < 30.0) it.advance() }
 * ```
 *
 * One step: forces act for its first half · spheres drift with every collision in time order · boundary conditions ·
 * forces act for its second half · swaps · sources and sinks ([StepPhases]) · outputs are called. Not thread-safe: one
 * thread calls; an engine may
 * use more within [advance].
 *
 * @param collisions null for spheres that pass through one another
 * @param runStart time at step 0, for a run that continues at [startStep]; null to count back from there, with a fixed
 *   step
 * @param forces act in this order before the drift and in the reverse order after it; a [Drift] next to it
 * @param elsewhere computes the steps in place of this process
 * @param clock gives the times after fixed steps; null for one that begins at [runStart]
 * @param partition says where the other spheres are, on a node that has a part of them
 * @param sources where spheres come and leave; null for none
 */
public class Simulation internal constructor(
    population: Population,
    public val boundary: BoundaryConditions,
    public val collisions: CollisionForcing?,
    internal val timeStep: TimeStep,
    forces: List<Force>,
    outputs: List<Output>,
    startTime: Double,
    startStep: Long,
    runStart: Double?,
    elsewhere: RemoteSteps?,
    clock: Clock?,
    partition: Partition,
    internal val sources: Sources?,
) : AutoCloseable {
    @JvmOverloads
    public constructor(
        population: Population,
        boundary: BoundaryConditions,
        collisions: CollisionForcing?,
        timeStep: TimeStep,
        forces: List<Force> = emptyList(),
        outputs: List<Output> = emptyList(),
        startTime: Double = 0.0,
        startStep: Long = 0,
        runStart: Double? = null,
        sources: Sources? = null,
    ) : this(
        population,
        boundary,
        collisions,
        timeStep,
        forces,
        outputs,
        startTime,
        startStep,
        runStart,
        null,
        null,
        Partition.Whole,
        sources,
    ) {
        if (collisions != null && startStep == 0L) collisions.isStartUnchecked = true
    }

    /** The spheres, at the end of the last step. Where nodes hold them, they are fetched at the first call. */
    public val population: Population = population
        get() {
            steps.bringHome()
            return field
        }

    /**
     * Mass, momentum and kinetic energy at the end of the last step, without round-off. Where nodes hold the spheres,
     * they take these sums, and the spheres stay there.
     */
    public fun conserved(): Conserved {
        var sums: Conserved? = null
        steps.sumElsewhere { sums = Conserved.of(it) }
        return sums ?: Conserved.of(population)
    }

    /** See [Steps.sumElsewhere]. */
    internal fun sumElsewhere(take: (RemoteParts) -> Unit): Boolean = steps.sumElsewhere(take)

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

    private val clock = clock ?: Clock(this.runStart)
    private val stops = (timeStep as? StoppingTimeStep)?.stops

    /** Length of the last step. */
    internal var lastDuration: Double = 0.0
        private set

    /** Time at the start of the last step. */
    internal var timeBefore: Double = startTime
        private set

    /**
     * The forces in the order in which they act before the drift. A [Drift] acts next to the drift: last before it,
     * first after it. A boundary that is a [Drift] is one of them.
     */
    public val forces: List<Force> =
        (forces + listOfNotNull(boundary as? Drift, energyOfPairs(forces))).sortedBy { it is Drift }

    private fun energyOfPairs(forces: List<Force>) =
        collisions?.states?.takeIf { forces.none { it is PairEnergy } }?.let { PairEnergy(it) }

    /** What computes the steps; null where spheres pass through one another. */
    internal val workforce: Workforce? = elsewhere ?: collisions?.engine
    private val loop = ClosableLoop(workforce?.loop ?: InlineLoop, CLOSED)
    private val steps: Steps =
        elsewhere ?: LocalSteps(
            StepPhases(population, boundary, collisions, this.forces, loop, partition, sources),
            timeStep,
        )
    private var opened = false
    private var busy = false

    private val outputs = OutputList(outputs)

    /** Whether this simulation was given outputs of its own. */
    internal val hasOutputs: Boolean get() = !outputs.isEmpty

    init {
        require(time.isFinite()) { "start time is $startTime; it must be finite" }
        require(this.forces.count { it is Drift } <= 1) { "two forces are a Drift; there can be only one" }
        for (force in this.forces) force.useLoop(loop)
        collisions?.bind(population, boundary, time)
    }

    /**
     * Advances the simulation by one step.
     *
     * A step is done completely or not at all. Whatever is thrown in it (by time step, force, engine, boundary or
     * output, even an [Error]) is passed on, and everything is as it was before: the population with the order of its
     * arrays, boxes crossed, counters, [time] and [step]. The record of collisions is empty. The step may then be done
     * again, with the same bits as result. Outputs that had seen it before another output threw are not called again.
     *
     * @throws IllegalArgumentException at step 0, when spheres that collide overlap. A later step may begin so: with the
     *   paper's boundary a sphere may be wrapped onto another one
     * @throws IllegalStateException when the state is no longer finite, after [close], and from within a step
     */
    public fun advance() {
        loop.requireOpen()
        check(!busy) { "a step is under way: advance() was called from within it" }
        open()
        val timeBefore = time
        val stepBefore = step
        steps.begin()
        busy = true
        try {
            carryOn()
            steps.commit()
        } catch (e: Throwable) {
            steps.takeBack()
            time = timeBefore
            step = stepBefore
            throw e
        } finally {
            busy = false
        }
    }

    private fun carryOn() {
        steps.carry(time, ::settle) { "step $step at time $time" }
        outputs.write(this)
    }

    /** Advances the clock by one step of [duration]. @return the time at its end */
    private fun settle(duration: Double): Double {
        step++
        lastDuration = duration
        timeBefore = time
        time = when {
            timeStep is FixedTimeStep -> clock.time(step, duration)
            stops != null -> stops.timeAfter(time, duration)
            else -> time + duration
        }
        return time
    }

    /**
     * Opens the outputs, and shows them the initial state of a simulation that starts. The first [advance] does this if
     * it was not done before. Each output is opened once and sees that state once, even if another throws.
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

    /**
     * Checks now, and so not in the first step, that no spheres which collide overlap. For callers that know them to be
     * finite and in the box.
     *
     * @throws IllegalArgumentException naming the deepest pair
     */
    public fun checkStart() {
        collisions?.checkStart(population, boundary, time)
    }

    /**
     * Sets the clock to [time] after [step] steps of a run that began with the state which this was made with. To be
     * called before everything else.
     */
    internal fun goOnFrom(time: Double, step: Long) {
        check(!opened && this.step == 0L) { "the simulation has begun: it is at step ${this.step}" }
        this.time = time
        this.step = step
        if (step > 0) collisions?.isStartUnchecked = false
    }

    /**
     * Ends the threads of the engine and closes the outputs; from then on [advance] throws [IllegalStateException], and
     * so do the loops which forces were given. A step under way, on another thread or around this call, either
     * succeeds, or throws and is as if it had not begun. Outputs are closed after it. Closing twice is allowed.
     */
    override fun close() {
        loop.close()
        AutoCloseable { steps.close() }.use { AutoCloseable { collisions?.close() }.use { outputs.close() } }
    }

    /** Does [act] while no step can begin. */
    internal inline fun hold(act: () -> Unit) {
        check(!busy) { "a step is under way" }
        busy = true
        try {
            act()
        } finally {
            busy = false
        }
    }

    public companion object {
        /** Names the parts of a simulation of [population] one by one. */
        @JvmStatic
        public fun builder(population: Population): SimulationBuilder = SimulationBuilder(population)

        private const val CLOSED = "the simulation is closed"
    }
}
