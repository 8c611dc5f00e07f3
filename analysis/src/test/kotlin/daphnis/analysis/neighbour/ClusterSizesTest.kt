package daphnis.analysis.neighbour

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.ln
import kotlin.math.pow
import kotlin.math.sqrt

class ClusterSizesTest {
    private val near = ClusterCriterion(1.1)

    private fun number(values: DoubleArray, name: String) = values[ClusterSizes.NUMBERS.indexOf(name)]

    /** Rows of touching spheres of these sizes, far from one another. */
    private fun rows(sizes: List<Int>): State {
        val edge = 2.0 + maxOf(sizes.max(), 1)
        val spheres = sizes.flatMapIndexed { k, size -> List(size) { Sphere(it + 0.5, 2.0 * k + 1, 1.0, r = 0.5) } }
        val box = Box(0.0, 0.0, 0.0, edge, 2.0 * sizes.size, 4.0)
        return State(populationOf(*spheres.toTypedArray()), Periodic(box), 0.0)
    }

    @Test
    fun `bins go on from one another, the first are single sizes`() {
        for (k in 0 until ClusterSizes.bins) {
            assertEquals(k, ClusterSizes.binOf(ClusterSizes.lowest(k)))
            assertEquals(k, ClusterSizes.binOf(ClusterSizes.highest(k)))
            if (k > 0) assertEquals(ClusterSizes.highest(k - 1) + 1, ClusterSizes.lowest(k))
        }
        assertEquals(10, ClusterSizes.highest(9))
        assertEquals(101, ClusterSizes.lowest(20))
        assertEquals(Int.MAX_VALUE, ClusterSizes.highest(ClusterSizes.bins - 1))
        assertThrows(IllegalArgumentException::class.java) { ClusterSizes.binOf(0) }
        assertThrows(IllegalArgumentException::class.java) { ClusterSizes(near, 0) }
    }

    @Test
    fun `numbers of made clusters are theirs, and one that spans is in no bin`() {
        val values = ClusterSizes(near).of(rows(listOf(12, 3, 3, 2, 1, 1)))
        assertEquals(4.0, number(values, "clusters"))
        assertEquals(20.0 / 22, number(values, "share"), 1e-12)
        assertEquals(12.0, number(values, "largest"))
        assertEquals(22.0 / 6, number(values, "mean_size"), 1e-12)
        assertEquals(168.0 / 22, number(values, "mean_size_of_sphere"), 1e-12)
        assertEquals(0.0, number(values, "spanning_share"))
        val bins = values.drop(ClusterSizes.NUMBERS.size)
        assertEquals(listOf(2.0, 1.0, 2.0), bins.take(3))
        assertEquals(1.0, bins[ClusterSizes.binOf(12)])
        assertEquals(6.0, bins.sum())
        val box = Box.centred(10.0, 10.0, 10.0)
        val chain =
            List(10) { Sphere(it - 4.5, r = 0.5) } + listOf(Sphere(0.0, 3.0, r = 0.5), Sphere(1.0, 3.0, r = 0.5))
        val spanning = ClusterSizes(near).of(State(populationOf(*chain.toTypedArray()), Periodic(box), 0.0))
        assertEquals(10.0 / 12, number(spanning, "spanning_share"), 1e-12)
        assertEquals(10.0, number(spanning, "largest"))
        assertEquals(1.0, spanning.drop(ClusterSizes.NUMBERS.size).sum())
        assertTrue(number(spanning, "slope").isNaN())
    }

    /** Sizes from 1 to [most] with probabilities ∝ s^−[slope]. */
    private class PowerLaw(slope: Double, most: Int) {
        private val sums = DoubleArray(most)

        init {
            var sum = 0.0
            for (s in 1..most) {
                sum += s.toDouble().pow(-slope)
                sums[s - 1] = sum
            }
        }

        val meanSize: Double =
            (1..sums.size).sumOf { it * (sums[it - 1] - (if (it > 1) sums[it - 2] else 0.0)) } / sums.last()

        fun next(random: SeededRandom): Int {
            val found = sums.binarySearch(random.nextDouble() * sums.last())
            return minOf(sums.size, (if (found >= 0) found else -found - 1) + 1)
        }
    }

    @Test
    fun `the slope of a power law is found, in a system of any number of spheres`() {
        for (slope in listOf(0.5, 1.5, 2.2, 3.5)) {
            for (most in listOf(40, 1000)) {
                val law = PowerLaw(slope, most)
                val random = SeededRandom(3)
                val counts = DoubleArray(ClusterSizes.bins)
                repeat(100_000) { counts[ClusterSizes.binOf(law.next(random))]++ }
                // Where the last bin ends no size is beyond: 40 and 1000 are such ends or inside one.
                val last = ClusterSizes.binOf(most)
                val from = IntArray(last + 1) { ClusterSizes.lowest(it) }
                val to = IntArray(last + 1) { minOf(most, ClusterSizes.highest(it)) }
                val found = SizeSlope.of(counts.copyOf(last + 1), from, to)
                val spread = sqrt(variance(slope, most) * 100_000)
                assertEquals(slope, found, 5 / spread) { "$slope up to $most" }
            }
        }
        assertTrue(SizeSlope.of(doubleArrayOf(3.0, 0.0), intArrayOf(1, 2), intArrayOf(1, 2)).isNaN())
        assertTrue(SizeSlope.of(DoubleArray(2), intArrayOf(1, 2), intArrayOf(1, 2)).isNaN())
        // As many clusters of each of two sizes: flat.
        assertEquals(0.0, SizeSlope.of(doubleArrayOf(2.0, 2.0), intArrayOf(1, 2), intArrayOf(1, 2)), 1e-6)
    }

    /** Of ln s: the information of one cluster on the slope. */
    private fun variance(slope: Double, most: Int): Double {
        val p = DoubleArray(most) { (it + 1.0).pow(-slope) }
        val mean = (0 until most).sumOf { p[it] * ln(it + 1.0) } / p.sum()
        return (0 until most).sumOf { p[it] * (ln(it + 1.0) - mean) * (ln(it + 1.0) - mean) } / p.sum()
    }

    @Test
    fun `points without correlation have as many pairs as follows from their density`() {
        // So few that larger clusters than pairs hardly are: N(N − 1)/2 · (4/3)πd³/V of them.
        val n = 200
        val d = 0.2
        val box = Box.centred(10.0, 10.0, 10.0)
        val expected = n * (n - 1) / 2.0 * 4 / 3 * PI * d * d * d / 1000
        val averages = Averages(ClusterSizes(ClusterCriterion(1.0)))
        repeat(900) { averages.add(uniform(n, Periodic(box), it + 1L, d / 2)) }
        val pairs = averages.average(ClusterSizes.NUMBERS.size + 1)
        val threes = averages.average(ClusterSizes.NUMBERS.size + 2)
        // A third one near a pair makes three of it, which has two or three links.
        assertTrue(threes.mean < 0.02)
        assertTrue(abs(pairs.mean + 2.5 * threes.mean - expected) < 4 * pairs.error) { "$pairs, expected $expected" }
        assertEquals(sqrt(expected / 900), pairs.error, 0.35 * pairs.error)
    }

    @Test
    fun `errors cover the mean over seeds in 60 to 75 of 100 cases`() {
        val law = PowerLaw(2.2, 60)
        val n = ClusterSizes.NUMBERS
        val sizes = ClusterSizes(near, 1)
        val clusters = 50
        val runs = List(400) { seed ->
            val random = SeededRandom(seed + 1L)
            val averages = Averages(Made(sizes) { List(clusters) { law.next(random) } })
            repeat(40) { averages.add(NONE) }
            averages
        }
        val checked = listOf("share", "largest", "mean_size", "mean_size_of_sphere", "slope").map { n.indexOf(it) } +
            listOf(0, 1, 4, 11, 14).map { n.size + it }
        for (k in checked) {
            val truth = runs.map { it.average(k).mean }.average()
            val covered = runs.count { abs(it.average(k).mean - truth) <= it.average(k).error } / 400.0
            assertTrue(covered in 0.60..0.75) { "number $k: $covered" }
        }
        val slope = runs.map { it.average(n.indexOf("slope")).mean }.average()
        assertEquals(2.2, slope, 0.02)
        assertEquals(law.meanSize, runs.map { it.average(n.indexOf("mean_size")).mean }.average(), 0.01 * law.meanSize)
    }

    /** The numbers of clusters of these sizes, whatever the state. */
    private class Made(private val sizes: ClusterSizes, private val next: () -> List<Int>) :
        daphnis.analysis.insitu.PooledMeasure {
        override fun sums(state: State): DoubleArray {
            val all = next().sortedDescending().toIntArray()
            return sizes.sums(Clusters(IntArray(0), all, List(3) { false }, BooleanArray(all.size), emptyArray()))
        }

        override fun finish(sums: DoubleArray, states: Int) = sizes.finish(sums, states)
    }

    private companion object {
        val NONE = State(populationOf(), Periodic(Box.centred(1.0, 1.0, 1.0)), 0.0)
    }
}
