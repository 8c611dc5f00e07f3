package daphnis.core.potential

import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.input.ValueCheck
import kotlinx.serialization.Serializable

/**
 * Chains of spheres as a scenario describes them, see [Chains].
 *
 * @property length number of spheres in a chain
 * @property least least distance of neighbours over the sum of their radii
 * @property greatest greatest one
 */
@Serializable
public class BondsSpec @JvmOverloads constructor(
    @Described("spheres in a chain, at least 2; 2 makes dimers")
    public val length: Int,
    @Described("greatest distance of neighbours over the sum of their radii")
    public val greatest: Double,
    @Described(
        "least distance over the same, at least 1: at 1 surfaces meet, as `restitution` says; beyond that the two " +
            "bounce without loss; default 1",
    )
    public val least: Double = 1.0,
) {
    /**
     * The chains, with the values checked.
     *
     * @throws daphnis.core.input.InputException for values that are wrong
     */
    public fun chains(check: ValueCheck): Chains {
        check.that("bonds.length", length, length >= 2) { "must be at least 2" }
        check.that("bonds.least", least, least >= 1 && least.isFinite()) { "must be at least 1, which is contact" }
        check.that("bonds.greatest", greatest, greatest > least && greatest <= MOST) {
            "must exceed least, $least, and be at most $MOST"
        }
        return Chains(length, Tether(least, greatest))
    }

    /** Distance of neighbours at the start over the sum of their radii. */
    internal val middle: Double get() = (least + greatest) / 2

    /** A description for a reader, with its numbers. */
    public fun inWords(): String = "chains of $length spheres, neighbours ${Quantities.number(
        least,
    )} to ${Quantities.number(greatest)} sums of radii apart"

    private companion object {
        const val MOST = 100.0
    }
}
