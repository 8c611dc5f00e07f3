package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population

/**
 * Something that changes velocities. Within a step spheres drift on straight lines, on which contacts are found
 * exactly. Forces act before and after the drift, so curved paths are approximated with an error of the order of the
 * step squared (docs/physics.md; kick–drift–kick, Quinn, Perrine, Richardson & Barnes 2010, AJ 139, 803).
 *
 * Most forces are a [Kick]; a rotating frame, which maps the state as a whole, is a [Drift]. Must change velocities
 * only, no positions, radii, masses, ids or the order, and must be a pure function of the population and the time: the
 * same bits for the same state, whatever the order of the arrays. A step that fails may be done again, so a force which
 * keeps sums of its own must allow for being called twice.
 */
public interface Force {
    /** Called before the drift of a step that begins at [start] and lasts [duration]. */
    public fun beforeDrift(population: Population, start: Double, duration: Double)

    /** Called after the drift and the boundary conditions of a step that ended at [end] and lasted [duration]. */
    public fun afterDrift(population: Population, end: Double, duration: Double)

    /**
     * Offers the threads of the engine for loops over spheres. Called once, before the first step. The loop throws once
     * the simulation is closed.
     */
    public fun useLoop(loop: RangeLoop): Unit = Unit

    /**
     * Potential energy of [population] in this force at [time], mass · (length/time)². It must not depend on the order
     * of the arrays. NaN where there is none: by default, and for a force that does work on a sphere each time it
     * passes through a periodic face.
     */
    public fun potentialEnergy(population: Population, boundary: BoundaryConditions, time: Double): Double = Double.NaN
}

/** A force given by the change of velocity it makes: applied for half the step before the drift and for half after. */
public fun interface Kick : Force {
    /** Adds acceleration × [duration] to the velocities, for the force at [time]. */
    public fun kick(population: Population, time: Double, duration: Double)

    override fun beforeDrift(population: Population, start: Double, duration: Double) {
        kick(population, start, duration / 2)
    }

    override fun afterDrift(population: Population, end: Double, duration: Double) {
        kick(population, end, duration / 2)
    }
}

/**
 * Represents a curved path by a straight one: replaces velocities by those of the drift, and those of the drift by true
 * ones. A simulation has at most one, and it acts last before the drift and first after it, whatever its place in the
 * list of forces. Its potential energy is that of the frame.
 */
public interface Drift : Force {
    /**
     * Angular speed about z of the axes in which spins are given. Within a step spins are kept in the axes of its
     * start; [afterDrift] is to turn them to those of its end, as seen from there by −[turning] times the duration.
     */
    public val turning: Double get() = 0.0
}
