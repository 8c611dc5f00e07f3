package daphnis.core.potential

import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.input.ValueCheck
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlin.math.abs

/**
 * What spheres do to one another besides impacts, as a scenario describes it. Ratios are distances over the sum of the
 * two radii; energies are in units of mass · (length/time)².
 */
@Serializable
public sealed interface InteractionSpec {
    /**
     * What stands at [key], with its values checked; null for nothing.
     *
     * @throws daphnis.core.input.InputException for values that are wrong
     */
    public fun interaction(key: String, check: ValueCheck): PairInteraction?

    /** A description for a reader, with its numbers. */
    public fun inWords(say: Quantities): String

    /** Whether spheres do nothing. */
    public val isNone: Boolean get() = false

    /** Whether the state of a pair depends on its past, and not on its distance alone. */
    public val remembers: Boolean get() = false

    /** Nothing, for pairs of materials where others do something. */
    @Serializable
    @SerialName("none")
    @Described("nothing, in `contacts`")
    public class None : InteractionSpec {
        override val isNone: Boolean get() = true

        override fun interaction(key: String, check: ValueCheck): PairInteraction? = null

        override fun inWords(say: Quantities): String = "none"
    }

    /** See [SteppedPotential.squareWell]. */
    @Serializable
    @SerialName("square-well")
    @Described("attraction within a distance")
    public class SquareWell(
        @Described("distance of the edge over the sum of the radii, > 1, ≤ 100")
        public val ratio: Double,
        @Described("energy, mass · speed², > 0")
        public val depth: Double,
    ) : InteractionSpec {
        override fun interaction(key: String, check: ValueCheck): PairInteraction {
            checkRatio("$key.ratio", ratio, check)
            check.positive("$key.depth", depth)
            return SteppedPotential.squareWell(ratio, depth)
        }

        override fun inWords(say: Quantities): String =
            "square well of depth ${say.energy(depth)} up to ${Quantities.number(ratio)} sums of radii"
    }

    /** See [SteppedPotential.squareShoulder]. */
    @Serializable
    @SerialName("square-shoulder")
    @Described("repulsion within a distance")
    public class SquareShoulder(
        @Described("distance of the edge over the sum of the radii, > 1, ≤ 100")
        public val ratio: Double,
        @Described("energy, mass · speed², > 0")
        public val height: Double,
    ) : InteractionSpec {
        override fun interaction(key: String, check: ValueCheck): PairInteraction {
            checkRatio("$key.ratio", ratio, check)
            check.positive("$key.height", height)
            return SteppedPotential.squareShoulder(ratio, height)
        }

        override fun inWords(say: Quantities): String =
            "square shoulder of height ${say.energy(height)} up to ${Quantities.number(ratio)} sums of radii"
    }

    /**
     * See [daphnis.core.potential.Bridge].
     *
     * @property radius of two spheres whose bridge takes [energy]; needed with an [exponent]
     */
    @Serializable
    @SerialName("bridge")
    @Described("a bond that forms at contact and breaks at an edge")
    public class Bridge @JvmOverloads constructor(
        @Described("distance at which it breaks over the sum of the radii, > 1, ≤ 100")
        public val ratio: Double,
        @Described("that breaking takes, mass · speed², > 0")
        public val energy: Double,
        @Described("of two equal spheres that have `energy`, where `exponent` is not 0")
        public val radius: Double? = null,
        @Described(
            "the energy goes as R_eff = r₁r₂/(r₁ + r₂) to this power, −10 to 10; 4/3 is that of elastic spheres " +
                "that stick (JKR); default 0",
        )
        public val exponent: Double = 0.0,
    ) : InteractionSpec {
        override val remembers: Boolean get() = true

        override fun interaction(key: String, check: ValueCheck): PairInteraction {
            checkRatio("$key.ratio", ratio, check)
            check.positive("$key.energy", energy)
            check.that("$key.exponent", exponent, abs(exponent) <= MOST_EXPONENT) {
                "must be at most $MOST_EXPONENT, and at least -$MOST_EXPONENT"
            }
            radius?.let { check.extent("$key.radius", it) }
            if (exponent == 0.0) return daphnis.core.potential.Bridge(ratio, energy)
            check.must("$key.radius", radius != null) {
                "is missing; give that of two spheres whose bridge takes energy"
            }
            return daphnis.core.potential.Bridge(ratio, energy, radius!!, exponent)
        }

        override fun inWords(say: Quantities): String =
            "bridge that forms at contact and breaks at ${Quantities.number(ratio)} sums of radii, which takes " +
                say.energy(energy) + if (exponent == 0.0) "" else " of two of radius ${say.length(radius!!)}"
    }

    /**
     * See [SteppedPotential].
     *
     * @property steps pairs of a ratio and the energy within it, from the outermost
     */
    @Serializable
    @SerialName("stepped")
    @Described(
        "any number of steps of energy; with one at ratio 1 spheres are not hard and may pass through one another",
    )
    public class Stepped(
        @Described("pairs of a ratio and the energy within it, the outermost first")
        public val steps: List<List<Double>>,
    ) : InteractionSpec {
        override fun interaction(key: String, check: ValueCheck): PairInteraction {
            val its = "$key.steps"
            check.that(its, steps, steps.isNotEmpty()) { "must have one step at least, such as [[1.5, -1]]" }
            for ((k, step) in steps.withIndex()) {
                check.that("$its[$k]", step, step.size == 2) { "must be a ratio and an energy" }
                val before = steps.getOrNull(k - 1)
                check.that("$its[$k]", step, step[0] <= MOST_REACH) { "must have a ratio of at most $MOST_REACH" }
                SteppedPotential.problem(step[0], before?.get(0), step[1], before?.get(1) ?: 0.0)
                    ?.let { check.fail("$its[$k]", "is wrong: $it") }
            }
            return SteppedPotential(
                DoubleArray(steps.size) { steps[it][0] },
                DoubleArray(steps.size) { steps[it][1] },
            )
        }

        override fun inWords(say: Quantities): String {
            val all = steps.joinToString { (ratio, energy) ->
                "${say.energy(energy)} within ${Quantities.number(ratio)}"
            }
            return "${steps.size} steps: $all sums of radii" +
                if (steps.last()[0] == 1.0) "; spheres can pass through one another" else ""
        }
    }
}

private fun checkRatio(key: String, ratio: Double, check: ValueCheck) = check.that(
    key,
    ratio,
    ratio > 1 && ratio <= MOST_REACH,
) {
    "must be > 1, which is contact, and at most $MOST_REACH"
}

/** Every sphere is asked for all that are so many sums of radii away. */
private const val MOST_REACH = 100.0
private const val MOST_EXPONENT = 10.0
