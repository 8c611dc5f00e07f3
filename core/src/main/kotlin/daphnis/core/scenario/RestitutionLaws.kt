package daphnis.core.scenario

import daphnis.core.collision.BorderiesRestitution
import daphnis.core.collision.BridgesRestitution
import daphnis.core.collision.ConstantRestitution
import daphnis.core.collision.Restitution

/** The law of what stands at [key], of speeds in [units]. */
internal fun RestitutionSpec.law(key: String, units: UnitsSpec, check: ValueCheck): Restitution = when (this) {
    is RestitutionSpec.Constant -> {
        check.fraction("$key.coefficient", coefficient)
        ConstantRestitution(coefficient)
    }
    is RestitutionSpec.Bridges -> {
        check.positive("$key.prefactor", prefactor)
        check.that("$key.exponent", exponent, exponent <= 0) { "must be <= 0" }
        BridgesRestitution(prefactor, exponent, units.speedInCmPerSecond)
    }
    is RestitutionSpec.Borderies -> {
        check.positive("$key.criticalSpeed", criticalSpeed)
        BorderiesRestitution(criticalSpeed, units.speedInCmPerSecond)
    }
}
