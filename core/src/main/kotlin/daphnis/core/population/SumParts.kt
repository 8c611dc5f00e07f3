package daphnis.core.population

/**
 * A population as [PopulationSums] sees it, held in one place or in several: its sums are taken in two rounds, in each
 * of which every part adds its own.
 */
internal interface SumParts {
    /** Makes [sums] the first moments of all parts. */
    fun first(sums: FirstMoments)

    /** Makes [sums] the second moments of all parts around [means], which stay as they are while [sums] are used. */
    fun central(means: Means, sums: CentralMoments)
}
