package daphnis.core.scenario

import daphnis.core.boundary.Box
import kotlin.math.abs
import kotlin.math.sqrt

/** The angular frequency [rate] of the orbit around, or of, [what]. */
internal class Pull(val rate: Double, val what: String)

/** The fastest orbit that the gravity of [setup] makes room for; null where nothing attracts. */
internal fun fastestPull(setup: ScenarioSetup): Pull? =
    setup.scenario.forces.mapNotNull { pull(setup, it) }.filter { it.rate > 0 }.maxByOrNull { it.rate }

private fun pull(setup: ScenarioSetup, force: ForceSpec): Pull? {
    val scenario = setup.scenario
    val p = setup.population
    val particles = (0 until p.size).filter { !scenario.isBody(p.id[it]) }
    return when (force) {
        is ForceSpec.UniformAcceleration, is ThermostatSpec -> null
        is ForceSpec.SelfGravity -> {
            // Waves along x do not see two spheres.
            if (force.method == GravityMethod.RADIAL_MODES) return null
            val g = force.constant ?: scenario.units.gravitationalConstant ?: return null
            val fastest = particles.maxOfOrNull { rate(2 * g * p.mass[it], 2 * p.radius[it], force.softening) }
            fastest?.let { Pull(it, "two spheres in contact") }
        }
        is ForceSpec.BodyGravity -> {
            val g = force.constant ?: scenario.units.gravitationalConstant ?: return null
            val smallest = particles.minOfOrNull { p.radius[it] } ?: return null
            val bodies = (0 until p.size).filter { scenario.isBody(p.id[it]) }
            val fastest = bodies.maxOfOrNull { rate(g * p.mass[it], p.radius[it] + smallest, force.softening) }
            fastest?.let { Pull(it, "an orbit on the surface of a body") }
        }
        is ForceSpec.Satellite -> {
            val smallest = particles.minOfOrNull { p.radius[it] } ?: return null
            val nearest = maxOf(force.radius + smallest, gap(setup.boundary.box, force))
            satelliteStrength(scenario, force)?.let {
                Pull(rate(it, nearest, force.softening), "an orbit as near to the satellite as spheres come")
            }
        }
    }
}

/** Of the orbit at [distance] around a mass of the given G times mass, with [softening]. */
private fun rate(strength: Double, distance: Double, softening: Double): Double {
    val square = distance * distance + softening * softening
    return sqrt(strength / (square * sqrt(square)))
}

/** Radially between the [box] and what the [moon] swings over; 0 where it swings into the box. */
private fun gap(box: Box, moon: ForceSpec.Satellite): Double =
    maxOf(0.0, abs(moon.x - (box.lowerX + box.upperX) / 2) - box.length(0) / 2 - moon.e)

private fun satelliteStrength(scenario: ScenarioParts, moon: ForceSpec.Satellite): Double? = when {
    moon.mass != null -> (moon.constant ?: scenario.units.gravitationalConstant)?.let { it * moon.mass }
    else -> (scenario.frame as? FrameSpec.Hill)?.let { frame ->
        frame.gravitationalParameter(scenario.units)?.let { it * (moon.massRatio ?: 0.0) }
    }
}

/** Toomre's 4π² G Σ/κ² of the particles of [setup]; null without Hill's frame or self-gravity. */
internal fun criticalWavelength(setup: ScenarioSetup): Double? {
    val scenario = setup.scenario
    val kappa = setup.frequencies?.kappa ?: return null
    val gravity = scenario.forces.filterIsInstance<ForceSpec.SelfGravity>().firstOrNull() ?: return null
    val g = gravity.constant ?: scenario.units.gravitationalConstant ?: return null
    val p = setup.population
    val mass = (0 until p.size).sumOf { if (scenario.isBody(p.id[it])) 0.0 else p.mass[it] }
    val box = setup.boundary.box
    return 4 * Math.PI * Math.PI * g * mass / (box.length(0) * box.length(1)) / (kappa * kappa)
}
