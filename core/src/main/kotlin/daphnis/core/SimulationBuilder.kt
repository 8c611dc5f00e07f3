package daphnis.core

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.Force
import daphnis.core.force.Kick
import daphnis.core.population.Population
import daphnis.core.source.Sources
import daphnis.core.surface.ContactLaw
import daphnis.core.surface.Restitution

/**
 * The parts of a [Simulation] by their names, from [Simulation.builder]. It needs a boundary, a time step, and one of
 * [restitution], [contactLaw], [collisions] and [withoutCollisions]. A part that is given again replaces the former one;
 * forces and outputs are added.
 *
 * ```java
 * Simulation simulation = Simulation.builder(population)
 *     .boundary(BoundaryConditions.open())
 *     .restitution(speed -> 0.8)
 *     .timeStep(0.1)
 *     .build();
 * ```
 */
public class SimulationBuilder internal constructor(private val population: Population) {
    private var boundary: BoundaryConditions? = null
    private var collisions: CollisionForcing? = null
    private var law: ContactLaw? = null
    private var isWithoutCollisions = false
    private var timeStep: TimeStep? = null
    private val forces = ArrayList<Force>()
    private val outputs = ArrayList<Output>()
    private var startTime = 0.0
    private var startStep = 0L
    private var runStart: Double? = null
    private var sources: Sources? = null

    /** What happens at the faces of the box. */
    public fun boundary(boundary: BoundaryConditions): SimulationBuilder = apply { this.boundary = boundary }

    /** Collisions by this law, on the serial engine; [collisions] says more. */
    public fun restitution(law: Restitution): SimulationBuilder = contactLaw(law)

    /** The same by a [law] of both coefficients; if it is rough, the population needs spins. */
    public fun contactLaw(law: ContactLaw): SimulationBuilder = apply { this.law = law }

    /** Collisions with a guard, an engine or a record of them, from [CollisionForcing.builder]. */
    public fun collisions(collisions: CollisionForcing): SimulationBuilder = apply { this.collisions = collisions }

    /** Spheres pass through one another. */
    public fun withoutCollisions(): SimulationBuilder = apply { isWithoutCollisions = true }

    /** Every step is [duration] long, in units of time. */
    public fun timeStep(duration: Double): SimulationBuilder = timeStep(FixedTimeStep(duration))

    /** Each step is as long as [step] chooses. */
    public fun timeStep(step: TimeStep): SimulationBuilder = apply { timeStep = step }

    /** A further force, which acts after those given before. */
    public fun force(force: Force): SimulationBuilder = apply { forces += force }

    /** A further force, as a lambda. */
    public fun kick(kick: Kick): SimulationBuilder = force(kick)

    /** Where spheres come and leave. */
    public fun sources(sources: Sources): SimulationBuilder = apply { this.sources = sources }

    /** A further output, which is called after those given before. */
    public fun output(output: Output): SimulationBuilder = apply { outputs += output }

    /** The time at which it begins, in units of time; 0 unless given. */
    public fun startTime(time: Double): SimulationBuilder = apply { startTime = time }

    /**
     * It continues a run that has made [step] steps.
     *
     * @param runStart time at step 0 of that run; null to count back from [startTime], with a fixed step
     */
    @JvmOverloads
    public fun startStep(step: Long, runStart: Double? = null): SimulationBuilder = apply {
        startStep = step
        this.runStart = runStart
    }

    /**
     * The simulation. Each call makes another one, of the same parts; two that share a population, an engine or an
     * output must not be advanced by turns.
     *
     * @throws IllegalArgumentException when a part is missing, or two contradict each other
     */
    public fun build(): Simulation = Simulation(
        population,
        requireNotNull(boundary) { "the simulation has no boundary; give boundary(…), such as Open" },
        forcing(),
        requireNotNull(timeStep) { "the simulation has no time step; give timeStep(…)" },
        forces.toList(),
        outputs.toList(),
        startTime,
        startStep,
        runStart,
        sources,
    )

    private fun forcing(): CollisionForcing? {
        val given = listOfNotNull(
            "restitution(…)".takeIf { law is Restitution },
            "contactLaw(…)".takeIf { law != null && law !is Restitution },
            "collisions(…)".takeIf { collisions != null },
            "withoutCollisions()".takeIf { isWithoutCollisions },
        )
        require(given.isNotEmpty()) {
            "the simulation does not say how spheres collide; give restitution(…), collisions(…) or withoutCollisions()"
        }
        require(given.size == 1) { "${given.joinToString(" and ")} contradict each other; one of them is enough" }
        return collisions ?: law?.let { CollisionForcing(it) }
    }
}
