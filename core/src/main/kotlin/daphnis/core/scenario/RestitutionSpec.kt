package daphnis.core.scenario

import daphnis.core.collision.BorderiesRestitution
import daphnis.core.collision.BridgesRestitution
import daphnis.core.collision.ConstantRestitution
import daphnis.core.collision.StepRestitution
import daphnis.core.collision.TableRestitution
import daphnis.core.collision.ViscoelasticRestitution
import daphnis.core.input.ValueCheck
import daphnis.core.space.Space
import daphnis.core.surface.ContactLaw
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The coefficient of normal restitution. All its speeds are in cm/s. */
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

    /**
     * [below] at speeds below [speed], and [coefficient] from there on.
     *
     * @property speed in cm/s
     */
    @Serializable
    @SerialName("step")
    public class Step @JvmOverloads constructor(
        public val speed: Double,
        public val coefficient: Double,
        public val below: Double = 1.0,
    ) : RestitutionSpec

    /** @property points pairs of a speed in cm/s and a coefficient, each speed larger than the one before */
    @Serializable
    @SerialName("table")
    public class Table(public val points: List<List<Double>>) : RestitutionSpec

    /**
     * Viscoelastic spheres: two of [radius] and [mass] that meet with [speed] have the [coefficient].
     *
     * @property speed in cm/s
     * @property radius null for that of all spheres, where they are equal
     * @property mass null for that which a sphere of [radius] has by [ParticlesSpec]
     */
    @Serializable
    @SerialName("viscoelastic")
    public class Viscoelastic @JvmOverloads constructor(
        public val coefficient: Double,
        public val speed: Double,
        public val radius: Double? = null,
        public val mass: Double? = null,
    ) : RestitutionSpec
}

/** ε at the lowest speeds: below 1 spheres can collapse. */
internal val RestitutionSpec.atRest: Double
    get() = when (this) {
        is RestitutionSpec.Constant -> coefficient
        is RestitutionSpec.Step -> below
        is RestitutionSpec.Table -> points[0][1]
        is RestitutionSpec.Bridges, is RestitutionSpec.Borderies, is RestitutionSpec.Viscoelastic -> 1.0
    }

/** The law that stands at [key] of [scenario], with its values checked. */
internal fun RestitutionSpec.law(scenario: Scenario, check: ValueCheck, key: String = "restitution"): ContactLaw {
    val unit = scenario.units.speedInCmPerSecond
    return when (this) {
        is RestitutionSpec.Constant -> {
            check.fraction("$key.coefficient", coefficient)
            ConstantRestitution(coefficient)
        }
        is RestitutionSpec.Bridges -> {
            check.positive("$key.prefactor", prefactor)
            check.that("$key.exponent", exponent, exponent <= 0) { "must be <= 0" }
            BridgesRestitution(prefactor, exponent, unit)
        }
        is RestitutionSpec.Borderies -> {
            check.positive("$key.criticalSpeed", criticalSpeed)
            BorderiesRestitution(criticalSpeed, unit)
        }
        is RestitutionSpec.Step -> {
            check.positive("$key.speed", speed)
            check.fraction("$key.coefficient", coefficient)
            check.fraction("$key.below", below)
            StepRestitution(speed, coefficient, below, unit)
        }
        is RestitutionSpec.Table -> table(key, unit, check)
        is RestitutionSpec.Viscoelastic -> viscoelastic(
            scenario.particles?.takeIf {
                it.materials == null
            },
            key,
            unit,
            scenario.space,
            check,
        )
    }
}

private fun RestitutionSpec.Table.table(key: String, unit: Double, check: ValueCheck): ContactLaw {
    check.that("$key.points", points, points.isNotEmpty()) { "must have one point at least, such as [[0.1, 0.9]]" }
    for ((k, point) in points.withIndex()) {
        val its = "$key.points[$k]"
        check.that(its, point, point.size == 2) { "must be a speed in cm/s and a coefficient" }
        val (speed, coefficient) = point
        check.that(its, point, speed >= 0 && speed.isFinite()) { "must have a speed of at least 0" }
        check.that(its, point, k == 0 || speed > points[k - 1][0]) {
            "must have a speed above that of the point before, ${points[k - 1][0]}"
        }
        check.that(its, point, coefficient in 0.0..1.0) { "must have a coefficient in [0, 1]" }
    }
    return TableRestitution(
        DoubleArray(points.size) { points[it][0] },
        DoubleArray(points.size) { points[it][1] },
        unit,
    )
}

private fun RestitutionSpec.Viscoelastic.viscoelastic(
    particles: ParticlesSpec?,
    key: String,
    unit: Double,
    space: Space,
    check: ValueCheck,
): ContactLaw {
    check.that("$key.coefficient", coefficient, coefficient > 0 && coefficient <= 1) { "must be in (0, 1]" }
    check.positive("$key.speed", speed)
    val r = radius ?: (particles?.sizes as? SizesSpec.Equal)?.radius
        ?: check.fail("$key.radius", "is missing; give that of two spheres that have the coefficient")
    check.extent("$key.radius", r)
    val m =
        mass ?: particles?.mass
            ?: particles?.let { it.density * space.volume(1.0) * r * r * if (space.isPlane) 1.0 else r }
            ?: check.fail("$key.mass", "is missing; give that of a sphere with the radius")
    check.positive("$key.mass", m)
    return ViscoelasticRestitution(coefficient, speed, r, m, unit)
}
