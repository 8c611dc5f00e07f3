package daphnis.core.scenario

import daphnis.core.collision.BorderiesRestitution
import daphnis.core.collision.BridgesRestitution
import daphnis.core.collision.ConstantRestitution
import daphnis.core.surface.ContactLaw
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
public sealed interface RestitutionSpec {
    @Serializable
    @SerialName("constant")
    public class Constant(public val coefficient: Double) : RestitutionSpec

    @Serializable
    @SerialName("bridges")
    public class Bridges @JvmOverloads constructor(
        public val prefactor: Double = 0.34,
        public val exponent: Double = -0.234,
    ) : RestitutionSpec

    /** @property criticalSpeed in cm/s */
    @Serializable
    @SerialName("borderies")
    public class Borderies(public val criticalSpeed: Double) : RestitutionSpec
}

/** What a scenario in [units] names, checked. */
internal fun RestitutionSpec.law(units: UnitsSpec, check: ValueCheck): ContactLaw {
    val unit = units.speedInCmPerSecond
    return when (this) {
        is RestitutionSpec.Constant -> {
            check.fraction("restitution.coefficient", coefficient)
            ConstantRestitution(coefficient)
        }
        is RestitutionSpec.Bridges -> {
            check.positive("restitution.prefactor", prefactor)
            check.that("restitution.exponent", exponent, exponent <= 0) { "must be <= 0" }
            BridgesRestitution(prefactor, exponent, unit)
        }
        is RestitutionSpec.Borderies -> {
            check.positive("restitution.criticalSpeed", criticalSpeed)
            BorderiesRestitution(criticalSpeed, unit)
        }
    }
}
