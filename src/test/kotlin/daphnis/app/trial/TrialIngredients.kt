package daphnis.app.trial

import daphnis.core.force.Force
import daphnis.core.force.ForcePlace
import daphnis.core.force.ForceSpec
import daphnis.core.force.Kick
import daphnis.core.input.Ingredients
import daphnis.core.input.Kind
import daphnis.core.input.Quantities
import daphnis.core.input.Quantities.Companion.number
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import daphnis.core.scenario.WallSurfaceSpec
import daphnis.core.scenario.WallTraits
import daphnis.core.surface.ContactLaw
import daphnis.core.surface.LawPlace
import daphnis.core.surface.Restitution
import daphnis.core.surface.RestitutionSpec
import daphnis.core.surface.RoughnessSpec
import daphnis.core.wall.ConeWall
import daphnis.core.wall.Wall
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction
import kotlin.math.sqrt

/** Ingredients of another library, as docs/internals/adding.md has them. */
// example: ingredients
class TrialIngredients : Ingredients {
    override val kinds: List<Kind<*>> = listOf(
        Kind(DragSpec::class, DragSpec.serializer()),
        Kind(AdhesiveSpec::class, AdhesiveSpec.serializer()),
        Kind(ConeWallSpec::class, ConeWallSpec.serializer()),
    )
}
// end

/** Drag −γ (v − u) toward a [wind] u that is the same everywhere, at the [rate] γ. */
// example: drag
@Serializable
@SerialName("drag")
class DragSpec(val rate: Double, val wind: List<Double> = listOf(0.0, 0.0, 0.0)) : ForceSpec {
    override val actsOnDiscs: Boolean get() = true
    override val heats: Boolean get() = false

    override fun force(place: ForcePlace): Force {
        place.check.atLeast0("${place.key}.rate", rate)
        place.check.that("${place.key}.wind", wind, wind.size == 3) { "must be three numbers" }
        return Kick { population, _, duration ->
            val loss = StrictMath.expm1(-rate * duration)
            for (axis in 0..2) {
                val v = population.velocity(axis)
                for (k in 0 until population.size) v[k] += loss * (v[k] - wind[axis])
            }
        }
    }

    override fun inWords(place: ForcePlace, population: Population, say: Quantities): String =
        "drag ${say.rate(rate)} in a wind of ${wind.joinToString { say.speed(it) }}"
}
// end

/** ε = e √(1 − (v₀/v)²) above the [threshold] v₀ in cm/s, and 0 below: spheres that stick lose what they need to part. */
@Serializable
@SerialName("adhesive")
class AdhesiveSpec(val coefficient: Double, val threshold: Double) : RestitutionSpec {
    override val atRest: Double get() = 0.0

    override fun law(place: LawPlace): ContactLaw {
        place.check.fraction("${place.key}.coefficient", coefficient)
        place.check.positive("${place.key}.threshold", threshold)
        return Restitution { speed ->
            val part = threshold / (speed * place.cmPerSecond)
            if (part >= 1) 0.0 else coefficient * sqrt(1 - part * part)
        }
    }

    override fun inWords(say: Quantities): String =
        "adhesive, ${number(coefficient)} far above ${number(threshold)} cm/s, 0 below"
}

/** The inside of a cone, from its [apex] along its [axis]: at h along it, it is [slope] · h wide. */
@Serializable
@SerialName("cone")
class ConeWallSpec(
    val apex: List<Double>,
    val axis: List<Double>,
    val slope: Double,
    override val restitution: Double? = null,
    override val roughness: RoughnessSpec? = null,
    override val temperature: Double? = null,
) : WallSurfaceSpec {
    override fun surface(key: String, check: ValueCheck): Wall {
        val its = WallTraits(this, key, check)
        check.positive("$key.slope", slope)
        return ConeWall(its.vector("apex", apex), its.direction("axis", axis), slope, its.face, its.roughness)
    }

    override fun named(length: DoubleFunction<String>): String = "cone from ${apex.map { length.apply(it) }}"

    override fun inWords(number: DoubleFunction<String>): String =
        "cone of slope ${number.apply(slope)} along (${axis.joinToString(" ") { number.apply(it) }})"
}

/** A second library with a drag. */
class TwiceDrag : Ingredients {
    override val kinds: List<Kind<*>> = listOf(Kind(DragSpec::class, DragSpec.serializer()))
}
