package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.population.Population

/**
 * The same constant acceleration for every sphere, such as gravity in a shaken box; in length/time². Without a [Drift]
 * contacts with walls are those of the parabolas too, however long the step.
 */
public class UniformAcceleration(internal val ax: Double, internal val ay: Double, internal val az: Double) :
    Kick,
    PerSphereEnergy {
    init {
        require(ax.isFinite() && ay.isFinite() && az.isFinite()) { "acceleration ($ax, $ay, $az) must be finite" }
    }

    override fun kick(population: Population, time: Double, duration: Double) {
        for (k in 0 until population.size) {
            population.vx[k] += ax * duration
            population.vy[k] += ay * duration
            population.vz[k] += az * duration
        }
    }

    /** Whether the box does not repeat along the acceleration. */
    override fun hasPotentialEnergy(boundary: BoundaryConditions): Boolean =
        !(ax != 0.0 && boundary.repeats(0) || ay != 0.0 && boundary.repeats(1) || az != 0.0 && boundary.repeats(2))

    /** −m a·r, 0 at the origin. */
    override fun potentialEnergies(population: Population, time: Double, from: Int, to: Int, into: DoubleArray) {
        val p = population
        for (k in from until to) into[k - from] = -p.mass[k] * (ax * p.x[k] + ay * p.y[k] + az * p.z[k])
    }
}

/** The sum of all uniform accelerations among [forces], along x, y, z. */
internal fun uniformAcceleration(forces: List<Force>): List<Double> {
    val uniform = forces.filterIsInstance<UniformAcceleration>()
    return listOf(uniform.sumOf { it.ax }, uniform.sumOf { it.ay }, uniform.sumOf { it.az })
}
