package daphnis.core.population

/**
 * The rest of the spheres, where a population is only what one node holds of them. All nodes call the same functions in
 * the same order; each call is a message to the others. Without nodes there is no rest ([Whole]).
 */
public interface Partition {
    /** Whether this node does what only one is to do. */
    public val isFirst: Boolean get() = true

    /**
     * Fills [place] with x, y, z and mass of the spheres with these [ids], four numbers each, whichever node has them;
     * NaN for one that is nowhere. [population] is this node's.
     */
    public fun find(population: Population, ids: IntArray, place: DoubleArray)

    /** Makes each of [sums] over the spheres of one node that over those of all. */
    public fun merge(sums: Array<ExactSum>)

    /** Makes each of [numbers], which are whole and below 2⁵³ in all, the sum over all nodes; exact in any order. */
    public fun add(numbers: DoubleArray)

    /** Makes each of [numbers] the greatest of all nodes. */
    public fun max(numbers: DoubleArray)

    /** What all nodes give, of which each may give another number: [own] first, then that of the others. */
    public fun gather(own: IntArray): IntArray

    /**
     * The columns at [places], which spheres have, and ids of the spheres of all nodes, without anything else: those of
     * [population] come first, in its order. Valid until the population changes.
     */
    public fun everyone(population: Population, places: IntArray): SphereColumns

    public companion object {
        /** [Whole], for Java. */
        @JvmStatic
        public fun whole(): Partition = Whole

        /** Places of positions and masses. */
        internal val MASSES = SphereQuantity.places { it == SphereQuantity.POSITION || it == SphereQuantity.MASS }
    }

    /** There is no rest. */
    public object Whole : Partition {
        override fun find(population: Population, ids: IntArray, place: DoubleArray) {
            for (n in ids.indices) {
                val k = population.indexOf(ids[n])
                place[4 * n] = if (k < 0) Double.NaN else population.x[k]
                place[4 * n + 1] = if (k < 0) Double.NaN else population.y[k]
                place[4 * n + 2] = if (k < 0) Double.NaN else population.z[k]
                place[4 * n + 3] = if (k < 0) Double.NaN else population.mass[k]
            }
        }

        override fun merge(sums: Array<ExactSum>): Unit = Unit

        override fun add(numbers: DoubleArray): Unit = Unit

        override fun max(numbers: DoubleArray): Unit = Unit

        override fun gather(own: IntArray): IntArray = own

        override fun everyone(population: Population, places: IntArray): SphereColumns = population
    }
}

/**
 * What sums over all spheres, or needs to see them all. On a node it is given the [partition] of its crew; from then on
 * all nodes call it at the same places, and each gets what it would give for all spheres in one place.
 */
public interface Partitioned {
    /** The spheres of the other nodes; none of them at first. */
    public var partition: Partition
}

/**
 * The first of [count] ids in a row above all that are there, the same on all nodes, which call this together.
 *
 * @throws IllegalArgumentException when there are no more
 */
internal fun Partition.nextId(population: Population, count: Long): Int {
    val highest = doubleArrayOf((population.id.maxOrNull() ?: -1).toDouble())
    max(highest)
    val last = highest[0].toLong() + count
    require(last < Int.MAX_VALUE) { "there are no more ids for new spheres; the highest would be $last" }
    return highest[0].toInt() + 1
}
