package daphnis.core.population

/**
 * A sum with one term for each sphere of a population. It is exact ([ExactSum]), so it does not depend on the order of
 * the arrays. Reused; allocates nothing.
 */
internal class SphereSum {
    private val sum = ExactSum()
    private val terms = DoubleArray(ParticleBlock.SPHERES)

    /** Σ [term] over [population]. */
    fun of(population: Population, term: SphereTerm): Double {
        sum.clear()
        ParticleBlock.forEach(0, population.size) { from, to ->
            for (k in from until to) terms[k - from] = term.of(k)
            sum.addAll(terms, 0, to - from)
        }
        return sum.value()
    }
}

/** What one sphere adds to a sum. */
internal fun interface SphereTerm {
    /** The term of the sphere at [index]. */
    fun of(index: Int): Double
}
