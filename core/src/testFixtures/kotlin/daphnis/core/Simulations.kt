package daphnis.core

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.NoGuard
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.Restitution

fun simulationOf(
    population: Population,
    boundary: BoundaryConditions,
    dt: Double,
    restitution: Restitution = ConstantRestitution(1.0),
    guard: CollapseGuard = NoGuard,
    engine: CollisionEngine = SerialEngine(),
    outputs: List<Output> = emptyList(),
    startStep: Long = 0,
): Simulation = Simulation(
    population,
    boundary,
    CollisionForcing(restitution, guard, engine, recordCollisions = true),
    FixedTimeStep(dt),
    outputs = outputs,
    startStep = startStep,
)

/** The digest after each of the next [steps] steps. */
fun digests(simulation: Simulation, steps: Int): List<String> = List(steps) {
    simulation.advance()
    stateDigest(simulation.population)
}
