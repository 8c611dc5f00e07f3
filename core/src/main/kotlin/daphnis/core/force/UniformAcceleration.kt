package daphnis.core.force

import daphnis.core.population.Population

/** The same constant acceleration for every sphere, such as gravity in a shaken box; in length/time². */
public class UniformAcceleration(private val ax: Double, private val ay: Double, private val az: Double) : Kick {
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
}
