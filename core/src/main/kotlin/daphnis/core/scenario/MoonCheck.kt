package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.hill.Epicycle
import daphnis.core.input.ValueCheck
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import kotlin.math.abs

/**
 * A satellite keeps its orbit whatever is in its way, so none may cross the plane of the patch, or lie in it, within a
 * body of the scenario: that would be thrown far away, or removed as ring matter is.
 */
internal class MoonCheck(
    private val scenario: Scenario,
    private val population: Population,
    private val boundary: BoundaryConditions,
    private val orbits: OrbitalFrequencies,
    private val check: ValueCheck,
) {
    /** Bodies are the last spheres of the population, on the free paths of their first velocities. */
    fun check() {
        val first = population.size - scenario.bodies.size
        for ((k, moon) in scenario.forces.withIndex()) {
            if (moon is ForceSpec.Satellite) for (b in scenario.bodies.indices) check(k, moon, b, first + b)
        }
    }

    private fun check(k: Int, moon: ForceSpec.Satellite, b: Int, index: Int) {
        val p = population
        val body = Epicycle.of(p.x[index], p.y[index], p.z[index], p.vx[index], p.vy[index], p.vz[index], orbits)
        val reach = moon.radius + p.radius[index] + moon.e + body.e
        // A body that swings through a face goes on at the other side.
        val images = if (boundary.repeats(0)) boundary.box.length(0).let { listOf(-it, 0.0, it) } else listOf(0.0)
        for (at in images.map { body.guidingX + it }) {
            check.that("forces[$k].x", moon.x, abs(moon.x - at) > reach) {
                "on its way the satellite crosses the plane within bodies[$b], whose orbit is at $at; " +
                    "it must be farther than $reach from there"
            }
        }
    }
}
