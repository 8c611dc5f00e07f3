package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.initial.Positions
import daphnis.core.initial.SeededRandom
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import daphnis.core.population.granularTemperature
import kotlin.math.sqrt

/** Draws the velocities that a scenario asks for, by sphere in the order of ids. */
internal class InitialVelocities(
    private val scenario: Scenario,
    private val boundary: BoundaryConditions,
    private val check: ValueCheck,
) {
    /** `v[axis][k]` of spheres of [masses] at [positions]. */
    fun draw(masses: DoubleArray, positions: Positions, random: SeededRandom): Array<DoubleArray> {
        val spec =
            scenario.velocities ?: check.fail("velocities", "is missing; it is needed unless the placement is a file")
        val v = Array(3) { DoubleArray(masses.size) }
        spec.field(check)?.let { field -> fill(v) { k, into -> field.draw(masses[k], random, into) } }
        if (spec.zeroMomentum && masses.size >= 2) for (component in v) subtractMean(component, masses)
        spec.exactly(masses)?.let { makeExact(it, spec.zeroMomentum, masses, positions, v) }
        if (spec.shearProfile) addMeanFlow(v, positions)
        check.must(
            "velocities",
            v.all { column ->
                column.all { it.isFinite() }
            },
        ) { "give speeds beyond what a double holds" }
        return v
    }

    private inline fun fill(v: Array<DoubleArray>, draw: (Int, DoubleArray) -> Unit) {
        val drawn = DoubleArray(3)
        for (k in v[0].indices) {
            draw(k, drawn)
            for (axis in 0 until boundary.space.dimensions) v[axis][k] = drawn[axis]
        }
    }

    private fun subtractMean(component: DoubleArray, masses: DoubleArray) {
        val mean = mean(component, masses)
        for (k in component.indices) component[k] -= mean
    }

    /**
     * Velocity of the centre of mass. For equal masses it is the plain mean, since the digests of known initial states
     * include its rounding.
     */
    private fun mean(component: DoubleArray, masses: DoubleArray): Double {
        if (masses.all { it == masses[0] }) return component.sum() / component.size
        var momentum = 0.0
        for (k in component.indices) momentum += masses[k] * component[k]
        return momentum / masses.sum()
    }

    /**
     * Scales velocities relative to the centre of mass, whose velocity does not change, so that the temperature that is
     * asked for is the one that is measured ([granularTemperature]): around the measured mean flow, and corrected for
     * the degrees of freedom which that takes.
     */
    private fun makeExact(
        wanted: Double,
        isAtRest: Boolean,
        masses: DoubleArray,
        positions: Positions,
        v: Array<DoubleArray>,
    ) {
        if (wanted == 0.0) return
        check.that("velocities.exact", true, masses.size >= 2) {
            "needs at least two particles; a single particle has no velocity relative to the centre of mass"
        }
        val means = DoubleArray(3) { if (isAtRest) 0.0 else mean(v[it], masses) }
        val factor = sqrt(wanted / temperature(masses, positions, v))
        for (axis in 0..2) for (k in masses.indices) v[axis][k] = means[axis] + factor * (v[axis][k] - means[axis])
    }

    /** The granular temperature of velocities [v] that the straight flow of the boundary is yet to be added to. */
    private fun temperature(masses: DoubleArray, positions: Positions, v: Array<DoubleArray>): Double {
        val w = Array(3) { v[it].copyOf() }
        addFlow(w, positions)
        val (x, y, z) = listOf(positions.x, positions.y, positions.z).map { it.copyOf() }
        val radii = DoubleArray(masses.size) { 1.0 }
        return granularTemperature(
            Population(x, y, z, w[0], w[1], w[2], radii, masses.copyOf()),
            boundary,
        )
    }

    private fun addMeanFlow(v: Array<DoubleArray>, positions: Positions) {
        if (boundary.meanFlow == null) {
            check.fail(
                "velocities.shearProfile",
                "is true; it needs a sheared boundary (${BoundarySpec.SHEARED})",
            )
        }
        addFlow(v, positions)
    }

    /** Adds the straight flow of the boundary, if it drives one. */
    private fun addFlow(v: Array<DoubleArray>, positions: Positions) {
        val flow = boundary.meanFlow ?: return
        val across = arrayOf(positions.x, positions.y, positions.z)[flow.normalAxis]
        for (axis in 0..2) {
            val gradient = flow.gradient(axis)
            if (gradient != 0.0) for (k in across.indices) v[axis][k] += gradient * across[k]
        }
    }
}
