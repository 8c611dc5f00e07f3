package daphnis.analysis.neighbour

import daphnis.analysis.insitu.PooledMeasure
import daphnis.analysis.insitu.State
import kotlin.math.floor
import kotlin.math.pow

/**
 * How many clusters there are and how large, of all spheres by a [criterion]. A size s is a number of members; a single
 * sphere is a cluster of one. As a measure it gives [NUMBERS] and then the mean number n of clusters of a state in each
 * of the [bins] of sizes; all are pure numbers.
 *
 * | number | what |
 * |---|---|
 * | clusters | number of clusters of two members or more |
 * | share | part of the spheres that is in these; NaN without spheres |
 * | largest | members of the largest cluster |
 * | mean_size | Σ s n/Σ n, the mean size of a cluster |
 * | mean_size_of_sphere | Σ s² n/Σ s n, the size of the cluster of a sphere, on average: weighted by the number of members, which of equal spheres is by mass (Stauffer & Aharony 1994, Introduction to Percolation Theory) |
 * | spanning_share | part of the spheres that is in clusters which span the box |
 * | slope | τ of n(s) ∝ s^−τ from [least] members on, of most likelihood: Clauset, Shalizi & Newman 2009, SIAM Rev. 51, 661, in bins as Virkar & Clauset 2014, Ann. Appl. Stat. 8, 89. That there is a slope does not say that n is a power law |
 *
 * The means, and the slope, are of all states together, see [PooledMeasure]. Their errors by
 * [daphnis.analysis.insitu.Averages] do not take clusters as independent, which the usual error of a slope does: what
 * counts is how states differ. Clusters that span the box are in no bin and not in the slope, since their size is that
 * of the box.
 *
 * @property least members of a cluster from which on the slope is taken, at least 1
 */
public class ClusterSizes @JvmOverloads constructor(
    private val criterion: ClusterCriterion,
    public val least: Int = 2,
) : PooledMeasure {
    init {
        require(least >= 1) { "the slope is of clusters of $least members or more; it must be at least 1" }
    }

    override fun sums(state: State): DoubleArray = sums(Clusters.of(state, criterion))

    /** The sums of a state whose clusters are [found]. */
    public fun sums(found: Clusters): DoubleArray {
        val sums = DoubleArray(BINS + bins)
        for ((k, size) in found.sizes.withIndex()) {
            sums[SPHERES] += size.toDouble()
            sums[ALL]++
            sums[SQUARES] += size.toDouble() * size
            if (size >= 2) {
                sums[CLUSTERS]++
                sums[MEMBERS] += size.toDouble()
            }
            if (found.isSpanning[k]) sums[SPANNING] += size.toDouble() else sums[BINS + binOf(size)]++
        }
        sums[LARGEST] = (found.sizes.firstOrNull() ?: 0).toDouble()
        return sums
    }

    override fun finish(sums: DoubleArray, states: Int): DoubleArray {
        val result = DoubleArray(NUMBERS.size + bins)
        result[0] = sums[CLUSTERS] / states
        result[1] = sums[MEMBERS] / sums[SPHERES]
        result[2] = sums[LARGEST] / states
        result[3] = sums[SPHERES] / sums[ALL]
        result[4] = sums[SQUARES] / sums[SPHERES]
        result[5] = sums[SPANNING] / sums[SPHERES]
        result[6] = slope(sums, sums[SPHERES] / states)
        for (k in 0 until bins) result[NUMBERS.size + k] = sums[BINS + k] / states
        return result
    }

    private fun slope(sums: DoubleArray, spheres: Double): Double {
        val first = binOf(least)
        val last = binOf(maxOf(least.toDouble(), minOf(spheres, Int.MAX_VALUE.toDouble())).toInt())
        val from = IntArray(last - first + 1) { maxOf(least, lowest(first + it)) }
        return SizeSlope.of(
            DoubleArray(from.size) { sums[BINS + first + it] },
            from,
            IntArray(from.size) { highest(first + it) },
        )
    }

    public companion object {
        /** Names of the first numbers, in their order. */
        @JvmField
        public val NUMBERS: List<String> =
            listOf("clusters", "share", "largest", "mean_size", "mean_size_of_sphere", "spanning_share", "slope")

        // Places of sums.
        private const val SPHERES = 0
        private const val ALL = 1
        private const val SQUARES = 2
        private const val CLUSTERS = 3
        private const val MEMBERS = 4
        private const val SPANNING = 5
        private const val LARGEST = 6
        private const val BINS = 7

        /** Sizes up to which each has a bin; further ones have [A_DECADE] for each factor of ten. */
        private const val SINGLE = 10
        private const val A_DECADE = 10

        /** The least size of each bin. */
        private val EDGES: IntArray = run {
            val wide = generateSequence(0) { it + 1 }
                .map { floor(SINGLE * 10.0.pow(it.toDouble() / A_DECADE) * (1 + 1e-12)) + 1 }
                .takeWhile { it < Int.MAX_VALUE }
                .map { it.toInt() }
            ((1..SINGLE).asSequence() + wide).toList().toIntArray()
        }

        /** Number of bins of sizes: 1 to 10 by themselves, and then ten for each factor of ten. */
        @JvmStatic
        public val bins: Int get() = EDGES.size

        /** The bin, from 0 on, of clusters of [size] members, at least 1. */
        @JvmStatic
        public fun binOf(size: Int): Int {
            require(size >= 1) { "a cluster of $size; it must have a member" }
            val found = EDGES.binarySearch(size)
            return if (found >= 0) found else -found - 2
        }

        /** The least size in [bin]. */
        @JvmStatic
        public fun lowest(bin: Int): Int = EDGES[bin]

        /** The largest size in [bin]. */
        @JvmStatic
        public fun highest(bin: Int): Int = if (bin == EDGES.lastIndex) Int.MAX_VALUE else EDGES[bin + 1] - 1
    }
}
