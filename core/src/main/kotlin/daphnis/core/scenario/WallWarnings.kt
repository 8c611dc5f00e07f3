package daphnis.core.scenario

import daphnis.core.population.granularTemperature
import daphnis.core.wall.Piston
import daphnis.core.wall.WallMotion
import daphnis.core.wall.pistons
import java.util.Locale
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A wall that goes through more than a cycle within a step of [dt]. Impacts are exact all the same; but states and rows
 * are of ends of steps, and the search for an impact looks at every piece of the motion.
 */
internal fun fastWall(setup: ScenarioSetup, dt: Double): String? {
    val face = WallFacesSpec.NAMES.indices.maxByOrNull { frequency(setup, it) } ?: return null
    val frequency = frequency(setup, face)
    if (frequency * dt <= 1) return null
    return String.format(
        Locale.ROOT,
        "timeStep: the wall %s goes through %.3g cycles in a step of %.3g; impacts are exact, but outputs are of " +
            "ends of steps, and each impact is searched through all of them; take steps of %.3g or less",
        WallFacesSpec.NAMES[face],
        frequency * dt,
        dt,
        1 / frequency,
    )
}

private fun frequency(setup: ScenarioSetup, face: Int): Double =
    setup.boundary.walls[face]?.motion?.takeIf { it.amplitude > 0 }?.frequency ?: 0.0

/** A piston whose force changes its speed in a step of [dt] by more than a part of that of spheres. */
internal fun coarsePiston(setup: ScenarioSetup, dt: Double): String? {
    val speed = sqrt(granularTemperature(setup.population, setup.boundary, setup.scenario.firstBody))
    fun part(piston: Piston) = abs(piston.force) / piston.mass * dt / speed
    val (face, piston) = setup.boundary.walls.pistons.entries.maxByOrNull { part(it.value) } ?: return null
    if (!(speed > 0) || part(piston) <= MOST_OF_SPEED) return null
    return String.format(
        Locale.ROOT,
        "timeStep: the force on the piston %s changes its speed by %.2g of the rms speed of a component in a step; " +
            "it takes up impacts once per step, so take steps of %.2g or less",
        WallFacesSpec.NAMES[face],
        part(piston),
        MOST_OF_SPEED * dt / part(piston),
    )
}

private const val MOST_OF_SPEED = 0.02
