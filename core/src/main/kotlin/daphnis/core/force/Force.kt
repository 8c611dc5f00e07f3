package daphnis.core.force

import daphnis.core.population.Population

/**
 * Something that changes velocities. Within a step spheres drift on straight lines, so that collisions are exact; forces act before and
 * after the drift (kick–drift–kick, Quinn, Perrine, Richardson & Barnes 2010, AJ 139, 803).
 *
 * Most forces are a [Kick]; a force that maps the state as a whole, such as a rotating frame, implements the two calls itself.
 * Must not change positions, and must be a pure function of the population and the time.
 */
public interface Force {
    /** Called before the drift of a step from [start] of [duration]. */
    public fun beforeDrift(population: Population, start: Double, duration: Double)

    /** Called after the drift and the boundary conditions. */
    public fun afterDrift(population: Population, start: Double, duration: Double)
}

/** A force given by the change of velocity it makes: applied for half the step before the drift and for half after. */
public fun interface Kick : Force {
    /** Adds acceleration × [duration] to the velocities, as the force is at [time]. */
    public fun kick(population: Population, time: Double, duration: Double)

    override fun beforeDrift(population: Population, start: Double, duration: Double) {
        kick(population, start, duration / 2)
    }

    override fun afterDrift(population: Population, start: Double, duration: Double) {
        kick(population, start + duration, duration / 2)
    }
}
