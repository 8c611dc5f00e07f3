package daphnis.core.population

/**
 * The rest of the spheres, where a population is only what one node holds of them. All nodes call the same functions in
 * the same order.
 */
internal interface Partition {
    /**
     * Fills [place] with x, y, z and mass of the spheres with these [ids], four numbers each, wherever they are;
     * NaN for one that is nowhere.
     */
    fun find(population: Population, ids: IntArray, place: DoubleArray)

    /** Makes each of [sums] over the spheres of one node that over those of all. */
    fun merge(sums: Array<ExactSum>)

    /** Makes each of [numbers], which are whole and below 2⁵³ in all, the sum over all nodes; exact in any order. */
    fun add(numbers: DoubleArray)

    /** Makes each of [numbers] the greatest of all nodes. */
    fun max(numbers: DoubleArray)

    /** There is no rest. */
    object Whole : Partition {
        override fun find(population: Population, ids: IntArray, place: DoubleArray) {
            for (n in ids.indices) {
                val k = population.indexOf(ids[n])
                place[4 * n] = if (k < 0) Double.NaN else population.x[k]
                place[4 * n + 1] = if (k < 0) Double.NaN else population.y[k]
                place[4 * n + 2] = if (k < 0) Double.NaN else population.z[k]
                place[4 * n + 3] = if (k < 0) Double.NaN else population.mass[k]
            }
        }

        override fun merge(sums: Array<ExactSum>) = Unit

        override fun add(numbers: DoubleArray) = Unit

        override fun max(numbers: DoubleArray) = Unit
    }
}
