package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.roomIn
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import daphnis.core.space.Space
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Steps of a scenario that leaves their length open. Contacts on straight paths are found exactly, so without forces
 * the length of a step decides only how much work there is. The figures behind it are in docs/performance.md.
 */
internal object FreePath {
    /**
     * Refuses a scenario in which the length of a step is physics.
     *
     * @param boundary made from [Scenario.boundary]
     */
    fun check(scenario: Scenario, boundary: BoundaryConditions, check: ValueCheck) {
        if (!scenario.timeStep.isChosen) return
        val orbit = "{\"type\": \"orbit-fraction\", \"steps\": 200}"
        val fixed = "{\"type\": \"fixed\", \"dt\": 0.01}"
        fun need(what: String, step: String): Nothing =
            check.fail("timeStep", "is needed, since $what; give one, such as $step")
        if (scenario.frame != null) need("paths in the frame are straight only within a step", orbit)
        if (scenario.forces.isNotEmpty()) need("forces[0] acts at the start and the end of each step", fixed)
        if ((0..2).any { boundary.contactFaces(it) == ContactFaces.WRAPPING }) {
            val name = scenario.boundary
            need("boundary $name brings spheres back at the end of a step, without looking for contacts", fixed)
        }
    }

    /**
     * How far the fastest sphere may move along an axis in a step: in proportion to the root of mean free path times
     * diameter, but no more than a part of the mean distance, which is less in very thin gases, and half the box.
     */
    fun length(population: Population, box: Box, boundary: BoundaryConditions): Double {
        val edge = (0..2).filter { boundary.contactFaces(it) != ContactFaces.OPEN }.minOfOrNull { box.length(it) }
        val volume = boundary.roomIn(box)
        val most = edge?.let { it / 2 } ?: Double.MAX_VALUE
        if (population.size == 0) return minOf(most, box.space.edge(volume))
        val distance = box.space.edge(volume / population.size)
        val path = minOf(cheapest(population, box.space, volume), DISTANCES * distance)
        return minOf(most, FASTEST * path)
    }

    /** Longest step for which images slide by no more than half a box. */
    fun longest(boundary: BoundaryConditions): Double {
        val shear = boundary.shear ?: return Double.MAX_VALUE
        return boundary.box.length(shear.slideAxis) / 2 / abs(shear.velocity)
    }

    /**
     * The way of a sphere in the cheapest step: a part of the geometric mean of the mean free path, by Enskog's theory,
     * and the diameter.
     */
    private fun cheapest(population: Population, space: Space, volume: Double): Double {
        var first = 0.0
        var second = 0.0
        var third = 0.0
        for (place in 0 until population.places) {
            val k = population.indexAt(place)
            if (k < 0) continue
            val r = population.radius[k]
            first += r
            second += r * r
            third += r * r * r
        }
        val n = population.size
        if (space.isPlane) {
            // Contact value of Henderson 1975 (Mol. Phys. 30, 971); the mean free path is that of discs.
            val filling = minOf(Math.PI * second / volume, DENSEST)
            val atContact = (1 - filling * 7 / 16) / ((1 - filling) * (1 - filling))
            return PART * sqrt(volume / (2 * sqrt(2.0) * n * atContact))
        }
        val filling = minOf(4.0 / 3 * Math.PI * third / volume, DENSEST)
        val empty = 1 - filling
        val atContact = (1 - filling / 2) / (empty * empty * empty)
        // Two spheres collide when their centres pass at less than this distance, in the root mean square.
        val diameter = sqrt(2 * (second / n + first / n * (first / n)))
        val freePathTimesDiameter = volume / (sqrt(2.0) * n * Math.PI * diameter * atContact)
        return PART * sqrt(freePathTimesDiameter)
    }

    /**
     * From filling factors of 0.01 to 0.5 the serial engine is quickest with 0.3 to 0.4 of that mean, and the others
     * are quickest there or nearly so. Steps are half to all of what is asked for, so this is more.
     */
    private const val PART = 0.45

    /** Mean distances between spheres which are about as much; less where the filling factor is below 0.001. */
    private const val DISTANCES = 0.6

    /** The largest component of all velocities in a gas, relative to the mean speed. */
    private const val FASTEST = 2.8

    /** Theory holds below it. */
    private const val DENSEST = 0.6
}
