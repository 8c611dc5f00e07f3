package daphnis.core.potential

import daphnis.core.surface.PairTable

/**
 * An interaction for each pair of materials, which does not depend on which of the two is named first; null where
 * there are only impacts. Pairs that are not named have that of all [others]. Immutable.
 *
 * ```java
 * PairInteractions all = new PairInteractions(null).between(0, 1, SteppedPotential.squareWell(1.5, 1.0));
 * ```
 */
public class PairInteractions private constructor(
    private val table: PairTable<PairInteraction?>,
    /** Chains, whose neighbours have their tether in place of an interaction; null where there are none. */
    public val chains: Chains? = null,
) {
    /** Every pair has the interaction of all [others]. */
    public constructor(others: PairInteraction?) : this(PairTable(others))

    /** The interaction of pairs that are not named. */
    public val others: PairInteraction? get() = table.others

    /** The same, but [interaction] for spheres of the materials of the numbers [first] and [second]. */
    public fun between(first: Int, second: Int, interaction: PairInteraction?): PairInteractions =
        PairInteractions(table.with(first, second, interaction), chains)

    /** The same, with [chains]. */
    public fun with(chains: Chains): PairInteractions = PairInteractions(table, chains)

    /** That of spheres of the materials of the numbers [first] and [second]; null where there are only impacts. */
    public operator fun get(first: Int, second: Int): PairInteraction? = table[first, second]

    /** The largest distance of an edge over the sum of the radii. */
    internal val reach: Double get() = maxOf(1.0, all.maxOf { it?.reach ?: 1.0 })

    /** Whether no spheres pass through one another. */
    internal val areHard: Boolean get() = all.all { it == null || it.isHard }

    /** All interactions, each once, that of all [others] first and the tether of [chains] last. */
    internal val all: List<PairInteraction?> = (table.values() + listOfNotNull(chains?.tether)).distinct()

    /** The place in [all] of that of the materials [first] and [second]. */
    internal fun place(first: Int, second: Int): Int = all.indexOf(table[first, second])

    /** Number of materials of which anything is said. */
    internal val materials: Int get() = table.size
}
