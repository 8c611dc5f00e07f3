package daphnis.app.describe

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.at
import daphnis.core.initial.fillingFactor
import daphnis.core.population.SpinSums
import daphnis.core.population.granularTemperature
import daphnis.core.scenario.ScenarioSetup
import kotlin.math.PI
import kotlin.math.sqrt

/**
 * How many collisions a run may have, before it is run. A ring forgets how it began: spheres of equal size have some 18
 * τ collisions per orbit where they swing through the plane once (docs/validation.md, τ = 0.1 to 1), as many times more
 * as they swing more often. Where the plane is as full as a liquid they have up to g times as many, g being the pair
 * correlation of Carnahan & Starling at contact, and far more in wakes: that is the upper end of the range. Without a
 * frame it is Enskog's rate at the start, where spins have shared their energy with motion; spheres that grow, that
 * gravity presses on a wall or that shear heats from rest have more.
 *
 * @property least per sphere and unit of time
 * @property most likewise
 * @property isOnlyLeast whether there are more than at the start, by a factor that is not known
 */
internal class CollisionRate private constructor(
    val least: Double,
    val most: Double,
    val isOnlyLeast: Boolean = false,
) {
    companion object {
        private const val PER_ORBIT = 18.0

        /** Filling factor in the middle plane over τ ν/Ω, at τ = 0.1 to 0.5. */
        private const val FILLING = 0.22

        /** How many times as many there are in wakes: 53 and 59 at r_h = 0.9, where spheres rest on each other. */
        private const val IN_WAKES = 60.0

        /** Above this a disordered liquid does not go. */
        private const val FULL = 0.5

        fun of(setup: ScenarioSetup): CollisionRate = setup.frequencies?.let { orbits ->
            val box = setup.boundary.box
            val depth = setup.population.radius.sumOf { PI * it * it } / (box.length(0) * box.length(1))
            val crossings = depth * orbits.verticalFactor
            val clumps = setup.scenario.forces.any { it.gathers }
            val more = if (clumps) IN_WAKES else correlation(FILLING * crossings)
            val rate = PER_ORBIT * crossings * orbits.omega / (2 * PI)
            CollisionRate(rate, rate * more)
        }
            ?: enskog(setup).let {
                if (it.isFinite()) CollisionRate(it, it, hasMoreLater(setup)) else CollisionRate(0.0, 0.0)
            }

        private fun hasMoreLater(setup: ScenarioSetup): Boolean {
            if (setup.boundary.meanFlow != null && temperature(setup) == 0.0) return true
            val growth = setup.scenario.growth
            if (growth != null && growth.rate > 0) return true
            return setup.scenario.forces.mapNotNull { it.acceleration }.any { acceleration ->
                (0 until setup.boundary.space.dimensions).any {
                    acceleration[it] != 0.0 && hasFloor(setup.boundary, it)
                }
            }
        }

        /** Whether spheres that are pressed along [axis] come to lie on something. */
        private fun hasFloor(boundary: BoundaryConditions, axis: Int) = when (boundary.contactFaces(axis)) {
            ContactFaces.WALL -> true
            ContactFaces.OPEN -> boundary.walls.surfaces.isNotEmpty()
            ContactFaces.WRAPPING, ContactFaces.PERIODIC -> false
        }

        private fun enskog(setup: ScenarioSetup): Double {
            val radii = setup.population.radius
            val room = setup.boundary
            if (radii.isEmpty() || !room.volume.isFinite()) return 0.0
            val temperature = temperature(setup)
            val mean = radii.average()
            if (room.space.isPlane) {
                // Henderson 1975, Mol. Phys. 30, 971.
                val part = minOf(fillingFactor(radii, room), FULL)
                val contact = (1 - 7.0 / 16 * part) / ((1 - part) * (1 - part))
                return 2 * sqrt(PI * temperature) * radii.size / room.volume * 2 * mean * contact
            }
            val squares = 2 * (radii.sumOf { it * it } / radii.size + mean * mean)
            return 4 * sqrt(PI * temperature) * radii.size / room.volume * squares *
                correlation(fillingFactor(radii, room))
        }

        /** Of motion; where there are spins, of motion and rotation together. */
        private fun temperature(setup: ScenarioSetup): Double {
            val ofMotion = setup.boundary.at(setup.scenario.startTime).let {
                granularTemperature(setup.population, it, setup.scenario.firstBody)
            }
            if (!setup.population.hasSpin) return ofMotion
            val space = setup.boundary.space
            val spins = SpinSums(setup.scenario.momentFactor, space).apply { take(setup.population) }
            val (straight, turns) = space.dimensions to space.rotations
            return (straight * ofMotion + turns * spins.temperature) / (straight + turns)
        }

        /** At contact. */
        private fun correlation(filling: Double) =
            minOf(filling, FULL).let { (1 - it / 2) / ((1 - it) * (1 - it) * (1 - it)) }
    }
}
