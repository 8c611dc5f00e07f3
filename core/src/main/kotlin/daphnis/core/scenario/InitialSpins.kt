package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.hasRoughWalls
import daphnis.core.initial.GaussianVelocities
import daphnis.core.initial.SeededRandom
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import kotlin.math.abs
import kotlin.math.sqrt

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
            boundary.hasRoughWalls

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
            val sigma = if (spec is SpinsSpec.Gaussian) deviation(spec, population, k) else 0.0
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

    private fun deviation(spec: SpinsSpec.Gaussian, p: Population, k: Int): Double {
        check.must("spins", (spec.sigma == null) != (spec.temperature == null)) {
            "needs exactly one of sigma and temperature"
        }
        spec.sigma?.let { sigma ->
            check.that("spins.sigma", sigma, sigma >= 0) { "must be at least 0" }
            return sigma
        }
        val temperature = spec.temperature ?: 0.0
        check.that("spins.temperature", temperature, temperature >= 0) { "must be at least 0" }
        return sqrt(temperature / (momentFactor * p.mass[k])) / p.radius[k]
    }

    private companion object {
        const val AXES = 3
    }
}
