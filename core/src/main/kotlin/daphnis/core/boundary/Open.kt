package daphnis.core.boundary

import daphnis.core.population.Population

/** No boundary: spheres may go anywhere. */
public object Open : BoundaryConditions {
    override val box: Box get() = Box.UNBOUNDED

    override fun endStep(population: Population, time: Double): Unit = Unit
}

/** No boundary in the plane: discs may go anywhere in it. */
internal object OpenPlane : BoundaryConditions {
    override val box: Box get() = Box.PLANE

    override fun endStep(population: Population, time: Double): Unit = Unit
}
