package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.EngineFactory
import daphnis.core.force.SelfGravity
import daphnis.core.population.PopulationSums
import daphnis.core.scenario.ScenarioSetup

/**
 * A simulation and the sums that its outputs keep.
 *
 * @param meta of the checkpoint it goes on from, or null at a start
 * @param source what to call the scenario in messages
 */
internal class RunParts(setup: ScenarioSetup, meta: CheckpointMeta?, source: String, engines: EngineFactory) {
    val sums = PopulationSums(setup.boundary.meanFlow, setup.angularSpeed, setup.scenario.firstBody)
    val transport: TransportRows? =
        if (setup.scenario.output.transportEvery == 0) {
            null
        } else {
            TransportRows(setup.forces.filterIsInstance<SelfGravity>().firstOrNull())
        }
    val statistics = CollisionStatistics()
    val simulation: Simulation = simulation(setup, meta, source, engines)

    init {
        if (meta != null && meta.collisionSums.isNotEmpty()) {
            statistics.restore(meta.collisionSums, meta.impactSpeeds.toLongArray())
        }
    }

    private fun simulation(
        setup: ScenarioSetup,
        meta: CheckpointMeta?,
        source: String,
        engines: EngineFactory,
    ): Simulation {
        val engine = engineOf(setup.scenario, source, engines)
        val output = setup.scenario.output
        val records = output.collisionLog || output.transportEvery > 0
        val forcing = CollisionForcing(setup.restitution, setup.guard, engine, records, setup.scenario.search)
        if (meta != null) {
            forcing.counters.collisions = meta.collisions
            forcing.counters.wallCollisions = meta.wallCollisions
            forcing.counters.guardActivations = meta.guardActivations
            forcing.counters.redoneSteps = meta.redoneSteps
            forcing.counters.causalityReplays = meta.causalityReplays
        }
        val start = setup.scenario.startTime
        return Simulation(
            setup.population,
            setup.boundary,
            forcing,
            setup.timeStep,
            setup.forces,
            startTime = meta?.time ?: start,
            startStep = meta?.step ?: 0,
            runStart = start,
        )
    }
}
