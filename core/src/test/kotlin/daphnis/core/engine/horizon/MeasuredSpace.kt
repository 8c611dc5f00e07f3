package daphnis.core.engine.horizon

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import daphnis.core.surface.ConstantRestitution

/** Makes this the space of a step of [duration], measured but not laid out. */
internal fun EpochSpace.measure(population: Population, boundary: BoundaryConditions, duration: Double) {
    val law = CollisionLaw(ConstantRestitution(1.0))
    val step = CollisionStep(population, boundary, law, CollisionCounters())
    step.duration = duration
    val prepared = PreparedStep()
    prepared.measure(step, InlineLoop)
    frame.takeOver(step, population, prepared.reach, InlineLoop)
    cells.speeds.measure(population)
}
