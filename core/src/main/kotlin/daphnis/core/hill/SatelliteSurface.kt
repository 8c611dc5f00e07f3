package daphnis.core.hill

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.population.Population

/**
 * A moon with a surface: a sphere which is inside it or touches it at the end of a step has fallen onto it and is
 * removed. The step has to be so short that no sphere passes through the moon within one step.
 *
 * @param inner the other boundary conditions, which act first
 * @param radius of the moon, > 0
 */
public class SatelliteSurface(
    private val inner: BoundaryConditions,
    private val satellite: Satellite,
    public val radius: Double,
) : BoundaryConditions by inner {
    init {
        require(radius > 0 && radius.isFinite()) { "radius of the satellite is $radius; it must be > 0" }
        require(!satellite.isFree) {
            "a satellite that feels forces has no surface: it would have to take up what falls"
        }
    }

    /**
     * Spheres removed by this object so far. Those of a step that fails afterwards are counted when the step is done
     * again, and only once.
     */
    public var removed: Long = 0
        private set
    private var removedBefore = 0L
    private var lastTime = Double.NaN

    override fun endStep(population: Population, time: Double) {
        inner.endStep(population, time)
        val at = satellite.state(time)
        val before = population.size
        population.retain { k ->
            val dx = population.x[k] - at[0]
            val dy = population.y[k] - at[1]
            val dz = population.z[k] - at[2]
            val reach = radius + population.radius[k]
            dx * dx + dy * dy + dz * dz > reach * reach
        }
        if (time != lastTime) removedBefore = removed
        lastTime = time
        removed = removedBefore + (before - population.size)
    }
}
