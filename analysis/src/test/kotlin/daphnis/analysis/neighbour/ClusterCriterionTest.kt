package daphnis.analysis.neighbour

import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.populationOf
import daphnis.core.potential.PairInteractions
import daphnis.core.potential.SteppedPotential
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ClusterCriterionTest {
    private val box = Box.centred(10.0, 10.0, 10.0)

    @Test
    fun `attraction reaches to the outermost edge that takes energy to leave`() {
        fun reach(vararg steps: Pair<Double, Double>) = SteppedPotential(
            steps.map { it.first }.toDoubleArray(),
            steps.map { it.second }.toDoubleArray(),
        ).attractiveReach
        assertEquals(1.5, reach(1.5 to -1.0))
        assertEquals(0.0, reach(1.5 to 1.0))
        // A barrier around a well, and a well around a core that repels.
        assertEquals(1.5, reach(2.0 to 0.5, 1.5 to -1.0))
        assertEquals(2.0, reach(2.0 to -1.0, 1.5 to 0.5))
        // A dip in a shoulder holds too.
        assertEquals(1.3, reach(2.0 to 1.0, 1.3 to 0.5))
    }

    @Test
    fun `each pair of materials has its own, and those that do not attract are never linked`() {
        val well = SteppedPotential.squareWell(1.5, 1.0)
        val pairs = PairInteractions(null).between(0, 1, well).between(1, 1, SteppedPotential.squareShoulder(2.0, 1.0))
        val criterion = checkNotNull(ClusterCriterion.of(pairs, 2))
        assertEquals(listOf(0.0, 1.5, 1.5, 0.0), listOf(0, 1).flatMap { i -> listOf(0, 1).map { criterion[i, it] } })
        assertEquals(1.5, criterion.reach)
        assertNull(ClusterCriterion.of(PairInteractions(SteppedPotential.squareShoulder(2.0, 1.0)), 0))
        // a b . a a: only unlike ones are linked, here through a face.
        val p = populationOf(*listOf(-4.9, 4.2, 0.0, 1.0).map { Sphere(it, r = 0.5) }.toTypedArray())
            .withMaterial(intArrayOf(0, 1, 0, 0), listOf("a", "b"))
        val found = Clusters.of(State(p, Periodic(box), 0.0), criterion)
        assertEquals(listOf(0, 0, 1, 2), found.label.toList())
        // Of spheres without materials the ratio of all others counts.
        assertEquals(
            4,
            Clusters.of(
                State(
                    populationOf(
                        *Array(4) {
                            Sphere(it * 1.0, r = 0.5)
                        },
                    ),
                    Periodic(box),
                    0.0,
                ),
                criterion,
            ).sizes.size,
        )
        for (wrong in listOf(-0.1, Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThrows(IllegalArgumentException::class.java) { ClusterCriterion(wrong) }
        }
    }

    @Test
    fun `clusters of all sizes are those of a search through all pairs and images, for any boundary`() {
        val time = 0.9
        for (boundary in listOf(Periodic(box), LeesEdwards(box, 0.7), HillSheet(box, 1.0), BoundaryConditions.open())) {
            for (seed in 1L..5L) {
                val p = uniform(150, Periodic(box), seed, 0.3).population
                val random = SeededRandom(seed)
                for (k in 0 until 150) p.radius[k] = random.nextDouble(0.1, 0.5)
                p.radius[149] = 1.5
                val state = State(p, boundary, time, firstBody = 149)
                val found = Clusters.of(state, ClusterCriterion(1.3))
                val images = Images().also { it.prepare(boundary, time) }
                val label = IntArray(150) { it }
                fun near(i: Int, j: Int): Boolean {
                    for (x in -1..1) {
                        for (y in -1..1) {
                            for (z in -1..1) {
                                val code = Images.code(x, y, z)
                                val d = (0..2).sumOf { axis ->
                                    val v = p.position(axis)[j] - p.position(axis)[i] + images.shift(code, axis)
                                    v * v
                                }
                                if (d <= 1.69 * (p.radius[i] + p.radius[j]) * (p.radius[i] + p.radius[j])) return true
                            }
                        }
                    }
                    return false
                }
                for (i in 0 until 150) {
                    for (j in 0 until i) {
                        if (label[i] != label[j] && near(i, j)) {
                            val old = label[i]
                            val new = label[j]
                            for (k in label.indices) if (label[k] == old) label[k] = new
                        }
                    }
                }
                val sizes = label.toList().groupingBy { it }.eachCount().values.sortedDescending()
                assertEquals(sizes, found.sizes.toList()) { "$boundary $seed" }
                for (i in 0 until 150) {
                    for (j in 0 until i) {
                        assertEquals(label[i] == label[j], found.label[i] == found.label[j])
                    }
                }
                assertTrue(sizes[0] > 2 && found.label[149] >= 0) { "a body is a member" }
            }
        }
    }

    @Test
    fun `none, one, all, and numbers that are none`() {
        val near = ClusterCriterion(1.1)
        val none = Clusters.of(State(populationOf(), Periodic(box), 0.0), near)
        assertEquals(0, none.sizes.size)
        assertTrue(Cluster.of(State(populationOf(), Periodic(box), 0.0), none).isEmpty())
        val sums = ClusterSizes(near)
        val empty = sums.of(State(populationOf(), Periodic(box), 0.0))
        assertEquals(0.0, empty[0])
        assertTrue(empty[1].isNaN() && empty[6].isNaN())
        val one = State(populationOf(Sphere(r = 0.5)), Periodic(box), 0.0)
        assertArrayEquals(intArrayOf(1), Clusters.of(one, near).sizes)
        assertTrue(Cluster.of(one, Clusters.of(one, near)).isEmpty())
        val all = State(populationOf(*Array(5) { Sphere(it * 1.0, r = 0.5) }), Periodic(box), 0.0)
        val found = Clusters.of(all, near)
        assertArrayEquals(intArrayOf(5), found.sizes)
        assertEquals(false, found.isSpanning[0])
        assertEquals(4.0, found.place(4, 0) - found.place(0, 0), 1e-12)
        all.population.y[2] = Double.NaN
        assertThrows(IllegalArgumentException::class.java) { Clusters.of(all, near) }
        assertThrows(IllegalArgumentException::class.java) { Cluster.of(one, found) }
    }
}
