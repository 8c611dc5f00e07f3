package daphnis.core.surface

import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.input.Quantities.Companion.number
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** See [ConstantRestitution]. */
@Serializable
@SerialName("constant")
@Described("the same for all impacts")
public class ConstantRestitutionSpec(
    @Described("in [0, 1]")
    public val coefficient: Double,
) : RestitutionSpec {
    override val constant: Double get() = coefficient

    override fun law(place: LawPlace): ContactLaw {
        place.check.fraction("${place.key}.coefficient", coefficient)
        return ConstantRestitution(coefficient)
    }

    override fun inWords(say: Quantities): String = "${number(coefficient)} at every speed"
}

/** See [BridgesRestitution]. */
@Serializable
@SerialName("bridges")
@Described("Bridges' law of ice: `prefactor` v^`exponent`, at most 1")
public data class BridgesSpec @JvmOverloads constructor(
    @Described("with v in cm/s; default 0.34")
    public val prefactor: Double = BridgesRestitution.LEWIS_PREFACTOR,
    @Described("a number; default −0.234")
    public val exponent: Double = BridgesRestitution.EXPONENT,
) : RestitutionSpec {
    override fun law(place: LawPlace): ContactLaw {
        place.check.positive("${place.key}.prefactor", prefactor)
        place.check.that("${place.key}.exponent", exponent, exponent <= 0) { "must be <= 0" }
        return BridgesRestitution(prefactor, exponent, place.cmPerSecond)
    }

    override fun inWords(say: Quantities): String = "bridges, ${number(prefactor)} v^${number(exponent)} with v in cm/s"
}

/**
 * See [BorderiesRestitution].
 *
 * @property criticalSpeed in cm/s
 */
@Serializable
@SerialName("borderies")
@Described("Borderies' law")
public class BorderiesSpec(
    @Described("in cm/s")
    public val criticalSpeed: Double,
) : RestitutionSpec {
    override fun law(place: LawPlace): ContactLaw {
        place.check.positive("${place.key}.criticalSpeed", criticalSpeed)
        return BorderiesRestitution(criticalSpeed, place.cmPerSecond)
    }

    override fun inWords(say: Quantities): String = "borderies, elastic below ${number(criticalSpeed)} cm/s"
}

/**
 * [below] at speeds below [speed], and [coefficient] from there on.
 *
 * @property speed in cm/s
 */
@Serializable
@SerialName("step")
@Described("one coefficient below a speed, another from there on")
public class StepRestitutionSpec @JvmOverloads constructor(
    @Described("in cm/s")
    public val speed: Double,
    @Described("from that speed on, in [0, 1]")
    public val coefficient: Double,
    @Described("below that speed, in [0, 1]; default 1")
    public val below: Double = 1.0,
) : RestitutionSpec {
    override val atRest: Double get() = below

    override fun law(place: LawPlace): ContactLaw {
        place.check.positive("${place.key}.speed", speed)
        place.check.fraction("${place.key}.coefficient", coefficient)
        place.check.fraction("${place.key}.below", below)
        return StepRestitution(speed, coefficient, below, place.cmPerSecond)
    }

    override fun inWords(say: Quantities): String =
        "step, ${number(below)} below ${number(speed)} cm/s, ${number(coefficient)} from there on"
}

/**
 * See [TableRestitution].
 *
 * @property points pairs of a speed in cm/s and a coefficient, each speed larger than the one before
 */
@Serializable
@SerialName("table")
@Described("linear between points")
public class TableRestitutionSpec(
    @Described("pairs of a speed in cm/s and a coefficient, each speed larger than the one before")
    public val points: List<List<Double>>,
) : RestitutionSpec {
    override val atRest: Double get() = points[0][1]

    override fun law(place: LawPlace): ContactLaw {
        val check = place.check
        val key = "${place.key}.points"
        check.that(key, points, points.isNotEmpty()) { "must have one point at least, such as [[0.1, 0.9]]" }
        for ((k, point) in points.withIndex()) {
            val its = "$key[$k]"
            check.that(its, point, point.size == 2) { "must be a speed in cm/s and a coefficient" }
            val (speed, coefficient) = point
            check.that(its, point, speed >= 0 && speed.isFinite()) { "must have a speed of at least 0" }
            check.that(its, point, k == 0 || speed > points[k - 1][0]) {
                "must have a speed above that of the point before, ${points[k - 1][0]}"
            }
            check.that(its, point, coefficient in 0.0..1.0) { "must have a coefficient in [0, 1]" }
        }
        fun column(n: Int) = DoubleArray(points.size) { points[it][n] }
        return TableRestitution(column(0), column(1), place.cmPerSecond)
    }

    override fun inWords(say: Quantities): String {
        val ends = listOf(points.first(), points.last()).map { (speed, its) ->
            "${number(its)} at ${number(speed)} cm/s"
        }
        return if (points.size == 1) {
            "table of 1 point, ${ends[0]}"
        } else {
            "table of ${points.size} points from ${ends[0]} to ${ends[1]}"
        }
    }
}

/**
 * Viscoelastic spheres: two of [radius] and [mass] that meet with [speed] have the [coefficient].
 *
 * @property speed in cm/s
 * @property radius null for that of all spheres, where they are equal
 * @property mass null for that which a sphere of [radius] has
 */
@Serializable
@SerialName("viscoelastic")
@Described("viscoelastic spheres")
public class ViscoelasticSpec @JvmOverloads constructor(
    @Described("of two equal spheres that meet with `speed`; in `contacts` of one that meets one of the other material")
    public val coefficient: Double,
    @Described("in cm/s")
    public val speed: Double,
    @Described("of these two, a length; default that of all spheres, where these are equal")
    public val radius: Double? = null,
    @Described("of these two; default what `particles` say of a sphere of that radius")
    public val mass: Double? = null,
) : RestitutionSpec {
    override val losesAlways: Boolean get() = coefficient < 1
    override val dependsOnSize: Boolean get() = true

    override fun law(place: LawPlace): ContactLaw {
        val check = place.check
        val key = place.key
        check.must("$key.radius", !place.isOfPair || radius != null || mass == null) {
            "is missing; give both radius and mass, or none of the two"
        }
        val its = if (radius != null) MeasuredSphere(radius, mass) else place.measured
        check.that("$key.coefficient", coefficient, coefficient > 0 && coefficient <= 1) { "must be in (0, 1]" }
        check.positive("$key.speed", speed)
        val r = its?.radius
            ?: check.fail("$key.radius", "is missing; give that of two spheres that have the coefficient")
        check.extent("$key.radius", r)
        val m = its.mass ?: mass ?: place.mass(r)
            ?: check.fail("$key.mass", "is missing; give that of a sphere with the radius")
        check.positive("$key.mass", m)
        return ViscoelasticRestitution(coefficient, speed, r, m, place.cmPerSecond)
    }

    override fun inWords(say: Quantities): String {
        val of = listOfNotNull(
            radius?.let { "radius ${say.length(it)}" },
            mass?.let { "mass ${say.mass(it)}" },
        ).joinToString(" and ")
        return "viscoelastic, ${number(coefficient)} at ${number(speed)} cm/s" +
            if (of.isEmpty()) "" else " of two spheres of $of"
    }
}
