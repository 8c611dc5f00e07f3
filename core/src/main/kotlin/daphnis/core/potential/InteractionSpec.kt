package daphnis.core.potential

import daphnis.core.input.Quantities
import daphnis.core.input.ValueCheck
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

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

    /** Nothing, for pairs of materials where others do something. */
    @Serializable
    @SerialName("none")
    public class None : InteractionSpec {
        override fun interaction(key: String, check: ValueCheck): PairInteraction? = null

        override fun inWords(say: Quantities): String = "none"
    }

    /** See [SteppedPotential.squareWell]. */
    @Serializable
    @SerialName("square-well")
    public class SquareWell(public val ratio: Double, public val depth: Double) : InteractionSpec {
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
    public class SquareShoulder(public val ratio: Double, public val height: Double) : InteractionSpec {
        override fun interaction(key: String, check: ValueCheck): PairInteraction {
            checkRatio("$key.ratio", ratio, check)
            check.positive("$key.height", height)
            return SteppedPotential.squareShoulder(ratio, height)
        }

        override fun inWords(say: Quantities): String =
            "square shoulder of height ${say.energy(height)} up to ${Quantities.number(ratio)} sums of radii"
    }

    /**
     * See [SteppedPotential].
     *
     * @property steps pairs of a ratio and the energy within it, from the outermost
     */
    @Serializable
    @SerialName("stepped")
    public class Stepped(public val steps: List<List<Double>>) : InteractionSpec {
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
