package daphnis.core.run

import daphnis.core.CommonNumber
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.cluster.FleetEngines
import daphnis.core.engine.EngineFactory
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.StepTally
import daphnis.core.population.MaterialSums
import daphnis.core.population.Partition
import daphnis.core.population.PopulationSums
import daphnis.core.population.SpinSums
import daphnis.core.scenario.OutputSpec
import daphnis.core.scenario.ResolvedScenario
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.scenario.carriesHeat
import daphnis.core.wall.pistons
import daphnis.core.wave.ModeSums

/**
 * What is run in a run directory, for a scenario and a [Program] alike.
 *
 * @property scenario null for a program
 * @property name the name of the run in the summary
 * @property until time at which it ends
 * @property endSlack how much a whole number of steps may fall short of [until] by round-off
 * @property output how often each file is written
 * @param own further outputs, by name
 * @property sums of the simulation's population, shared by all outputs
 */
internal class RunPlan(
    val scenario: ResolvedScenario?,
    val name: String,
    val until: Double,
    val endSlack: Double,
    val output: OutputSpec,
    own: Map<String, Output>,
    val simulation: Simulation,
    sums: PopulationSums,
) : AutoCloseable {
    /** Further outputs, by name; they say it when they fail. */
    val own: Map<String, Output> = named(own, simulation)
    val sums = StepSums(
        sums,
        spinSums(simulation),
        materialSums(simulation, scenario),
        if (ModesOutput.times(output).isNever) null else ModeSums(output.modes, simulation.boundary, sums.firstBody),
        simulation.boundary.walls.areDriven,
        simulation.boundary.walls.surfaces.size,
        simulation.boundary.growth != null,
        simulation.boundary.walls.pistons.keys,
        simulation.collisions?.states != null,
        simulation.collisions?.isPlain != false,
        simulation.sources?.all?.size ?: 0,
    )

    /** Whether the run ends before [until], with the present state. */
    fun isOver(): Boolean {
        val growth = simulation.boundary.growth ?: return false
        return scenario?.growth?.isOver(growth.reducedPressure) { CommonNumber.FILLING_FACTOR.anywhere(simulation) }
            ?: false
    }

    override fun close() {
        simulation.close()
    }
}

private fun spinSums(simulation: Simulation): SpinSums? {
    if (!simulation.population.hasSpin) return null
    return simulation.collisions?.let { SpinSums(it.momentFactor, simulation.boundary.space) } ?: SpinSums()
}

private fun materialSums(simulation: Simulation, scenario: ResolvedScenario?): MaterialSums? {
    val names = simulation.population.materials
    if (names.isEmpty()) return null
    val boundary = simulation.boundary
    return MaterialSums(names, boundary.meanFlow, scenario?.firstBody ?: Int.MAX_VALUE, boundary.space)
}

/**
 * The plan of a scenario.
 *
 * @param meta of the checkpoint from which it continues, or null at a start
 * @param source what to call the scenario in messages
 */
internal fun planOf(
    setup: ScenarioSetup,
    meta: CheckpointMeta?,
    source: String,
    engines: EngineFactory,
    own: Map<String, Output>,
): RunPlan {
    RunOutputs.requireFree(own.keys)
    val scenario = setup.scenario
    val output = scenario.output
    val readers = PeriodicOutputs.readingCollisions(output)
    val nodes = engines as? FleetEngines
    val engine = if (nodes == null) engineOf(scenario, source, engines) else SerialEngine()
    val simulation = closingIfItThrows(nodes?.fleet ?: engine) {
        // Somebody else's outputs may read the record where there is one.
        val areSummed = nodes != null && own.isEmpty() && readers.isNotEmpty() && readers.all { it.sumsCollisions }
        val forcing = setup.collisions(engine, readers.isNotEmpty() && !areSummed)
        if (areSummed) forcing.tally = StepTally(setup.boundary.walls.areDriven, setup.carriesHeat)
        meta?.countInto(forcing.counters)
        meta?.put(setup.boundary, setup.forces)
        val time = meta?.time ?: scenario.startTime
        val step = meta?.step ?: 0
        forcing.bind(setup.population, setup.boundary, time)
        val elsewhere = nodes?.steps(setup, setup.population, forcing, time, step)
        Simulation(
            setup.population, setup.boundary, forcing, setup.timeStep, setup.forces, emptyList(), time, step,
            scenario.startTime, elsewhere, scenario.clock, Partition.Whole, setup.sources,
        )
    }
    return closingIfItThrows(simulation) {
        val boundary = setup.boundary
        val flow = boundary.meanFlow
        val sums = PopulationSums(flow, setup.frequencies, scenario.firstBody, boundary.space, setup.carriesHeat)
        RunPlan(scenario, scenario.name, scenario.end, endSlack(scenario.timeStep), output, own, simulation, sums)
    }
}

private inline fun <T> closingIfItThrows(owner: AutoCloseable, make: () -> T): T = try {
    make()
} catch (e: Throwable) {
    owner.use { throw e }
}
