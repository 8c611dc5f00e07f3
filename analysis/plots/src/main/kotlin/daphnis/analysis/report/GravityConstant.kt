package daphnis.analysis.report

import daphnis.core.scenario.ForceSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ThermostatSpec

/** G in the units of a scenario. */
internal object GravityConstant {
    /** That of the gravity of its spheres, else Newton's; null where neither is known. */
    fun of(scenario: Scenario): Double? = scenario.forces.firstNotNullOfOrNull {
        when (it) {
            is ForceSpec.BodyGravity -> it.constant
            is ForceSpec.SelfGravity -> it.constant
            is ForceSpec.Satellite, is ForceSpec.UniformAcceleration, is ThermostatSpec -> null
        }
    } ?: scenario.units.gravitationalConstant
}
