package daphnis.core.engine.islands

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Open
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.CollisionStep
import daphnis.core.population.Population

/** A step of unit length with elastic collisions. */
internal fun stepOf(population: Population, boundary: BoundaryConditions = Open): CollisionStep {
    val step = CollisionStep(population, boundary, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters())
    return step.apply { duration = 1.0 }
}

/** What [workers] share at the beginning of such a step, whose one window is all of it. */
internal fun fieldOf(population: Population, boundary: BoundaryConditions = Open, workers: Int = 2): IslandField {
    val step = stepOf(population, boundary)
    return IslandField(workers).apply {
        measure(step)
        prepare(step)
        windowEnd = 1.0
    }
}
