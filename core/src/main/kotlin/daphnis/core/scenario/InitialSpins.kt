package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.initial.GaussianVelocities
import daphnis.core.initial.SeededRandom
import daphnis.core.initial.SpinsSpec
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import kotlin.math.abs

/** Whether spheres spin and with what moment of inertia, and the spins with which they start. */
internal class InitialSpins(
    private val scenario: Scenario,
    private val boundary: BoundaryConditions,
    private val check: ValueCheck,
) {
    /** Whether a surface is rough, or spheres are to spin all the same. */
    val areThere: Boolean
        get() = scenario.roughness != null ||
            scenario.contacts.any { it.roughness != null } ||
            boundary.walls.any { it.roughness != null }

    /** Moment of inertia over mass · radius². */
    val momentFactor: Double get() = scenario.momentFactor

    /** Checks what can be wrong whether or not spins are drawn. */
    fun check() {
        check.must("spins", scenario.spins == null || areThere) {
            "are of spheres that spin; give roughness, such as {\"type\": \"smooth\"}"
        }
        val factor = momentFactor
        check.that("roughness.momentFactor", factor, factor > 0 && factor <= scenario.space.mostMomentFactor) {
            "must be > 0 and ${scenario.space.mostMomentInWords}"
        }
    }

    /**
     * [population] with spins drawn from [random] in the order of its arrays, its last [bodies] spheres at rest; the
     * same population where nothing spins.
     */
    fun drawn(population: Population, bodies: Int, random: SeededRandom): Population {
        check()
        if (!areThere) return population
        val spec = scenario.spins ?: SpinsSpec.Rest()
        check.that("spins.mean", spec.mean, spec.mean.size == AXES && spec.mean.all { it.isFinite() }) {
            "must be three numbers, along x, y and z"
        }
        val space = scenario.space
        check.that("spins.mean", spec.mean, !space.isPlane || spec.mean[0] == 0.0 && spec.mean[1] == 0.0) {
            "must be 0 along x and y, with dimensions 2"
        }
        // Discs spin about z alone.
        val first = AXES - space.rotations
        val w = Array(AXES) { DoubleArray(population.size) }
        val into = DoubleArray(AXES)
        val field = GaussianVelocities(1.0)
        for (k in 0 until population.size - bodies) {
            val sigma = spec.deviation(momentFactor, population.mass[k], population.radius[k], check)
            if (sigma > 0) field.draw(random, into)
            for (axis in first until AXES) w[axis][k] = spec.mean[axis] + sigma * into[axis]
        }
        for (column in w) {
            for (k in column.indices) {
                check.must("spins", abs(column[k]) * population.radius[k] <= ValueCheck.MOST) {
                    "make the surface of particle ${population.id[k]} move with a speed of " +
                        "${abs(column[k]) * population.radius[k]}; it must be at most ${ValueCheck.MOST}"
                }
            }
        }
        return population.withSpin(w[0], w[1], w[2])
    }

    private companion object {
        const val AXES = 3
    }
}
