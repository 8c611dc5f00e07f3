package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.force.Drift
import daphnis.core.force.Force
import daphnis.core.force.UniformAcceleration
import daphnis.core.input.InputException
import daphnis.core.input.ValueCheck
import daphnis.core.parallel.onThreads
import daphnis.core.population.Population
import daphnis.core.search.Reach

/**
 * Refuses forces with which no run could make its first step, before it begins: they act for the first half of that
 * step, on a copy of the spheres. What they do later depends on the collisions.
 *
 * @param forces in the order in which they act; those of the scenario first. They are not those of the run
 */
internal class FirstKick(
    private val scenario: Scenario,
    private val forces: List<Force>,
    private val boundary: BoundaryConditions,
    private val check: ValueCheck,
) {
    /**
     * @param isPlaced false where spheres placed at random are not where they will be: then only what acts alike
     *   everywhere is tried
     * @throws InputException that names the first force after which the step cannot be made
     */
    fun check(population: Population, duration: Double, isPlaced: Boolean) {
        if (forces.isEmpty() || population.size == 0) return
        val spheres = population.copy()
        onThreads(scenario.engine.threadsAtStart, spheres.size) { loop ->
            for ((k, force) in forces.withIndex()) {
                if (!isPlaced && force !is UniformAcceleration && force !is Drift) continue
                force.useLoop(loop)
                try {
                    force.beforeDrift(spheres, scenario.startTime, duration)
                    Reach().measure(spheres, boundary, duration)
                } catch (e: IllegalArgumentException) {
                    check.fail(key(k), "cannot act in the first step: ${e.message}")
                }
            }
        }
    }

    private fun key(k: Int): String = when {
        k < scenario.forces.size -> "forces[$k]"
        (scenario.frame?.verticalFactor ?: 0.0) > 1 -> "frame.verticalFactor"
        else -> "frame"
    }
}
