package daphnis.core.swap

import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.input.ValueCheck
import kotlinx.serialization.Serializable

/**
 * How often spheres swap places, as a scenario describes it, see [SwapRule].
 *
 * @property rate pairs drawn per sphere and unit of time
 */
@Serializable
public class SwapsSpec(
    @Described(
        "pairs drawn per sphere and unit of time, > 0; two alike are among them, and stay; at most 1000 per " +
            "sphere in a step",
    )
    public val rate: Double,
) {
    /**
     * The rule that stands at [key].
     *
     * @param seed decides which are drawn
     * @throws daphnis.core.input.InputException for a rate that is wrong
     */
    public fun rule(key: String, seed: Long, check: ValueCheck): SwapRule {
        check.positive("$key.rate", rate)
        return SwapRule(rate, seed)
    }

    /**
     * Checks that steps like the first one, of [duration], have few enough draws for the [spheres], and that those until [end]
     * can be counted.
     */
    internal fun checkDraws(key: String, spheres: Int, duration: Double, end: Double, check: ValueCheck) {
        check.that("$key.rate", rate, rate * duration <= MOST_IN_STEP) {
            "draws more than ${MOST_IN_STEP.toInt()} pairs per sphere in a step of $duration; take a smaller rate or dt"
        }
        check.that("$key.rate", rate, rate * spheres * end <= MOST_IN_ALL) {
            "draws more than $MOST_IN_ALL pairs until $end"
        }
    }

    /** A description for a reader, of [spheres] in a step of [duration]. */
    public fun inWords(spheres: Int, duration: Double, say: Quantities): String {
        val draws = rate * duration * spheres
        return "${say.rate(rate)} per sphere; ${Quantities.number(draws)} pairs of $spheres spheres drawn in a step, " +
            "one thread"
    }
}

/** Pairs drawn per sphere in a step, and in a whole run, which is 2⁵³. */
private const val MOST_IN_STEP = 1000.0
private const val MOST_IN_ALL = 9.007199254740992e15
