package daphnis.core.engine.threadpool

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.ConstantRestitution
import daphnis.core.population.Population
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep

/** A step of unit length with elastic collisions, before the first of them. */
internal fun preparedOf(population: Population, boundary: BoundaryConditions): PreparedStep {
    val step = CollisionStep(population, boundary, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters())
    step.duration = 1.0
    return PreparedStep().apply {
        measure(step)
        prepare()
    }
}
