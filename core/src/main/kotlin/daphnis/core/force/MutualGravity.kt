package daphnis.core.force

import daphnis.core.population.Population

/** Gravity of all spheres on one another, however it is summed. */
public interface MutualGravity : Kick {
    /** Where gravity ends, by the distance along the periodic axes; infinite when it does not. Length. */
    public val range: Double

    /** Accelerations x y z by index in [population], with its state at [time]; valid until the next call. */
    public fun accelerations(population: Population, time: Double): Array<DoubleArray>

    /**
     * Flux of y momentum along +x that gravity carries at this moment, times the volume: −½ Σ_ij F_y,ij (x_j − x_i),
     * where F_ij is the force of j on i, over images too. A uniform sheet has none. For the state of [population] at
     * [time].
     */
    public fun stressXY(population: Population, time: Double): Double
}
