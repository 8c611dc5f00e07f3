package daphnis.core.merging

import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.input.ValueCheck
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** Which impacts merge spheres, as a scenario describes it, see [MergeRule]. */
@Serializable
public sealed interface MergingSpec {
    /**
     * The rule that stands at [key], with its values checked.
     *
     * @param gravitationalConstant G in the scenario's units; null where it is not known
     * @throws daphnis.core.input.InputException for values that are wrong
     */
    public fun rule(key: String, gravitationalConstant: Double?, check: ValueCheck): MergeRule

    /** A description for a reader, with its numbers. */
    public fun inWords(say: Quantities): String

    /** See [MergeRule.always]. */
    @Serializable
    @SerialName("always")
    @Described("every impact merges")
    public class Always : MergingSpec {
        override fun rule(key: String, gravitationalConstant: Double?, check: ValueCheck): MergeRule =
            MergeRule.always()

        override fun inWords(say: Quantities): String = "in every impact"
    }

    /** See [MergeRule.below]. */
    @Serializable
    @SerialName("slow")
    @Described("impacts slower than this merge")
    public class Slow(
        @Described("of the whole relative velocity of the centres, > 0")
        public val speed: Double,
    ) : MergingSpec {
        override fun rule(key: String, gravitationalConstant: Double?, check: ValueCheck): MergeRule {
            check.positive("$key.speed", speed)
            return MergeRule.below(speed)
        }

        override fun inWords(say: Quantities): String = "in impacts slower than ${say.speed(speed)}"
    }

    /** See [MergeRule.belowEscape]. */
    @Serializable
    @SerialName("escape")
    @Described("impacts slower than so many speeds of escape √(2Gm/d) of the two from each other merge")
    public class Escape @JvmOverloads constructor(
        @Described("how many; default 1")
        public val factor: Double = 1.0,
    ) : MergingSpec {
        override fun rule(key: String, gravitationalConstant: Double?, check: ValueCheck): MergeRule {
            check.positive("$key.factor", factor)
            val constant = gravitationalConstant
                ?: check.fail(
                    key,
                    "needs the gravitational constant; give units.lengthInMetres and massInKg, or a force",
                )
            return MergeRule.belowEscape(constant, factor)
        }

        override fun inWords(say: Quantities): String =
            "in impacts slower than ${Quantities.number(factor)} times the speed of escape from each other"
    }
}
