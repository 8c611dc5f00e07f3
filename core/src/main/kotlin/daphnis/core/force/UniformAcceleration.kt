package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.population.Population
import daphnis.core.population.SphereSum

/** The same constant acceleration for every sphere, such as gravity in a shaken box; in length/time². */
public class UniformAcceleration(private val ax: Double, private val ay: Double, private val az: Double) : Kick {
    private val sum = SphereSum()

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

    /** −Σ m a·r, 0 at the origin; NaN when the box repeats along the acceleration. */
    override fun potentialEnergy(population: Population, boundary: BoundaryConditions, time: Double): Double {
        if (ax != 0.0 && boundary.repeats(0)) return Double.NaN
        if (ay != 0.0 && boundary.repeats(1)) return Double.NaN
        if (az != 0.0 && boundary.repeats(2)) return Double.NaN
        val p = population
        return sum.of(p) { k -> -p.mass[k] * (ax * p.x[k] + ay * p.y[k] + az * p.z[k]) }
    }
}
