package daphnis.core.population

/**
 * A sum with one term for each sphere of a population. It is exact ([ExactSum]), so it does not depend on the order of
 * the arrays. Reused; allocates nothing.
 */
internal class SphereSum {
    private val sum = ExactSum()

    /** For one block. */
    val terms = DoubleArray(ParticleBlock.SPHERES)

    private val sums = arrayOf(sum)

    /** Σ [term] over [population], and over those of the other nodes of [partition]. */
    fun of(population: Population, partition: Partition = Partition.Whole, term: SphereTerm): Double {
        sum.clear()
        addBlocks(0, population.size, sum) { from, to, into ->
            for (k in from until to) into[k - from] = term.of(k)
        }
        partition.merge(sums)
        return sum.value()
    }

    /** Adds to [sum] what [fill] writes for each range of the indices [from] until [to], from its first entry on. */
    inline fun addBlocks(from: Int, to: Int, sum: ExactSum, fill: (from: Int, to: Int, into: DoubleArray) -> Unit) {
        ParticleBlock.forEach(from, to) { start, end ->
            fill(start, end, terms)
            sum.addAll(terms, 0, end - start)
        }
    }
}

/** What one sphere adds to a sum. */
internal fun interface SphereTerm {
    /** The term of the sphere at [index]. */
    fun of(index: Int): Double
}
