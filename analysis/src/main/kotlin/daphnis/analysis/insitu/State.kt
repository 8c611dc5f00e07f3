package daphnis.analysis.insitu

import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.at
import daphnis.core.boundary.isChanging
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import kotlin.math.PI

/**
 * A state to be measured: a population as it stands, shared and not copied, in its boundary conditions. Of a live
 * simulation between two steps, or of a file.
 *
 * @property frequencies of orbits in Hill's frame, or null when there is none
 * @property firstBody spheres with ids from this on are bodies, such as moonlets, which most quantities leave out;
 *   [Int.MAX_VALUE] for none
 */
public class State @JvmOverloads constructor(
    public val population: Population,
    boundary: BoundaryConditions,
    public val time: Double,
    public val frequencies: OrbitalFrequencies? = null,
    public val firstBody: Int = Int.MAX_VALUE,
) {
    /** What it is at the [time]. */
    public val boundary: BoundaryConditions = boundary.at(time)

    /** In Hill's frame of angular speed [omega] around a point mass. */
    @JvmOverloads
    public constructor(
        population: Population,
        boundary: BoundaryConditions,
        time: Double,
        omega: Double,
        firstBody: Int = Int.MAX_VALUE,
    ) : this(population, boundary, time, OrbitalFrequencies(omega), firstBody)

    /** Angular speed of Hill's frame, or null when there is none. */
    public val omega: Double? get() = frequencies?.omega

    /** 3, or 2 for discs in the plane z = 0. */
    public val dimensions: Int get() = boundary.space.dimensions

    /** Area of the box in the x-y plane. */
    public val area: Double get() = boundary.box.length(0) * boundary.box.length(1)

    /** The same over a period in which the box becomes wider and narrower. */
    public val meanArea: Double get() {
        val period = frequencies?.let { 2 * PI / it.kappa }
        if (period == null || !boundary.isChanging) return area
        return listOf(0.0, period / 2).map { boundary.at(it).box }.sumOf { it.length(0) * it.length(1) } / 2
    }

    /** Whether the sphere at [index] is a particle and not a body. */
    public fun isParticle(index: Int): Boolean = firstBody == Int.MAX_VALUE || population.id[index] < firstBody

    /**
     * Velocity component [axis] of the sphere at [index] against the straight flow of the boundary's rate. Not the
     * peculiar velocity, which is against the mean flow as it is measured: a bin or a group has its own mean to take
     * out.
     */
    public fun againstFlow(index: Int, axis: Int): Double {
        val v = population.velocity(axis)[index]
        val flow = boundary.meanFlow ?: return v
        val gradient = flow.gradient(axis)
        if (gradient == 0.0) return v
        return v - gradient * population.position(flow.normalAxis)[index]
    }

    public companion object {
        /** The state of [simulation] between two steps. */
        @JvmStatic
        @JvmOverloads
        public fun of(simulation: Simulation, frequencies: OrbitalFrequencies? = null): State =
            State(simulation.population, simulation.boundary, simulation.time, frequencies)
    }
}
