package daphnis.core.boundary

import daphnis.core.population.Population

/** No boundary: spheres may go anywhere. */
public object Open : BoundaryConditions {
    override val box: Box get() = Box.UNBOUNDED

    override fun endStep(population: Population, time: Double): Unit = Unit
}
