package daphnis.analysis.report

import daphnis.analysis.insitu.State
import daphnis.core.scenario.Scenario
import daphnis.core.surface.RoughnessSpec
import kotlin.math.abs

/** The one kind of gas whose numbers theory knows: elastic spheres of one size and mass, at rest, filling all space. */
internal object ElasticGas {
    /** Relative difference at which two lengths or masses still count as equal. */
    private const val SAME = 1e-9

    /** Whether [last] is a state of such a gas, in a box that repeats along all axes; none swap places and velocities. */
    fun isSeen(scenario: Scenario, last: State): Boolean = scenario.swaps == null &&
        isAtRest(scenario, last) && areEqual(last.population.radius) && areEqual(last.population.mass)

    /** The same of spheres that may differ in size and mass. */
    fun isAtRest(scenario: Scenario, last: State): Boolean =
        scenario.restitutionAtRest == 1.0 && (0 until last.dimensions).all { last.boundary.repeats(it) }

    /** Whether spheres slide on one another without friction. */
    fun isSmooth(scenario: Scenario): Boolean = scenario.impacts.all { it.roughness?.isSmooth != false }

    /** Whether that box is a cube, too. */
    fun isCube(scenario: Scenario, last: State): Boolean {
        val box = last.boundary.box
        return isSeen(scenario, last) && last.dimensions == 3 && areEqual(DoubleArray(3) { box.length(it) })
    }

    /** Whether all [values] are the same; not of none. */
    fun areEqual(values: DoubleArray): Boolean =
        values.isNotEmpty() && values.all { abs(it - values[0]) <= SAME * abs(values[0]) }
}
