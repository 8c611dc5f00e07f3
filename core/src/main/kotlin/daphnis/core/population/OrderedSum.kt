package daphnis.core.population

/**
 * Sums over the spheres of a population in the order of their ids, so that they are the same to the last bit whatever
 * order the arrays are in.
 */
internal class OrderedSum {
    private val slots = IdSlots()
    private var terms = DoubleArray(0)

    /** Σ [term] over [population]. */
    fun of(population: Population, term: SphereTerm): Double {
        slots.prepare(population)
        val count = slots.count
        if (terms.size < count) terms = DoubleArray(count)
        if (count > population.size) terms.fill(0.0, 0, count)
        val id = population.id
        for (k in 0 until population.size) terms[slots.of(id[k])] = term.of(k)
        var sum = 0.0
        for (place in 0 until count) sum += terms[place]
        return sum
    }
}

/** What one sphere adds to a sum. */
internal fun interface SphereTerm {
    /** The term of the sphere at [index]. */
    fun of(index: Int): Double
}
