package daphnis.core.merging

import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.input.ValueCheck
import kotlinx.serialization.Serializable

/**
 * Which impacts break spheres, and into what, as a scenario describes it, see [BreakRule].
 *
 * @property smallest radius of a piece; a sphere whose pieces would be smaller does not break
 */
@Serializable
public class BreakingSpec(
    @Described("normal component of the relative velocity above which spheres break, ≥ 0")
    public val speed: Double,
    @Described("of each sphere, 2 to 1000")
    public val pieces: Int,
    @Described("speed at which pieces leave the centre of their sphere, > 0; of an odd number one stays there")
    public val spread: Double,
    @Described("radius of a piece, > 0; a sphere whose pieces would be smaller does not break")
    public val smallest: Double,
) {
    /**
     * The rule that stands at [key], with its values checked.
     *
     * @param seed decides where pieces fly
     * @throws daphnis.core.input.InputException for values that are wrong
     */
    public fun rule(key: String, seed: Long, check: ValueCheck): BreakRule {
        check.atLeast0("$key.speed", speed)
        check.that("$key.pieces", pieces, pieces in 2..BreakRule.MOST_PIECES) {
            "must be in 2..${BreakRule.MOST_PIECES}"
        }
        check.positive("$key.spread", spread)
        check.positive("$key.smallest", smallest)
        return BreakRule(speed, pieces, spread, smallest, seed)
    }

    /** A description for a reader, with its numbers. */
    public fun inWords(say: Quantities): String =
        "into $pieces pieces in impacts faster than ${say.speed(speed)}, which fly apart at ${say.speed(spread)}; " +
            "none smaller than ${say.length(smallest)}"
}
