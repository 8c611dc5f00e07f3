package daphnis.analysis.neighbour

import daphnis.analysis.correlation.ContactValues
import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.hypot
import kotlin.math.sqrt

/** Periodic boxes thinner than neighbours reach: a particle has several images of one, and its own. */
class ThinBoxTest {
    private fun population(vararg at: DoubleArray): Population {
        val zero = DoubleArray(at.size)
        val x = List(3) { axis -> DoubleArray(at.size) { at[it][axis] } }
        val half = DoubleArray(at.size) { 0.5 }
        return Population(x[0], x[1], x[2], zero, zero.copyOf(), zero.copyOf(), half, half.copyOf())
    }

    /** Distances to all particles and images, up to five boxes away, in ascending order. */
    private fun distances(state: State, i: Int): DoubleArray {
        val p = state.population
        val images = Images().also { it.prepare(state.boundary, state.time) }
        val most = IntArray(3) { if (state.boundary.hasImages(it)) 5 else 0 }
        val all = ArrayList<Double>()
        for (x in -most[0]..most[0]) {
            for (y in -most[1]..most[1]) {
                for (z in -most[2]..most[2]) {
                    val code = Images.code(x, y, z)
                    for (j in 0 until p.size) {
                        if (i == j && code == 0 || !state.isParticle(j)) continue
                        val d = DoubleArray(3) { p.position(it)[j] - p.position(it)[i] + images.shift(code, it) }
                        all += hypot(hypot(d[0], d[1]), d[2])
                    }
                }
            }
        }
        return all.sorted().toDoubleArray()
    }

    private fun boundaries() = listOf(
        Periodic(Box.centred(9.0, 8.0, 2.2)),
        Periodic(Box.centred(9.0, 0.9, 1.8)),
        Periodic(Box.centred(9.0, 8.0, 2.2), true, false, true),
        LeesEdwards(Box.centred(2.2, 2.5, 7.0), 0.7),
        LeesEdwards(Box.centred(8.0, 1.2, 3.0), 0.7),
        HillSheet(Box.centred(2.1, 1.9, 4.0), 1.0),
        Periodic(Box.flat(20.0, 2.4)),
        Periodic(Box.flat(20.0, 0.7)),
    )

    @Tag("thorough")
    @Test
    fun `neighbours by solid angle and within a distance are those of a search through all images`() {
        for ((k, boundary) in boundaries().withIndex()) {
            val box = boundary.box
            val p = uniform(30, Periodic(box), 3, 0.3).population
            if (box.space.isPlane) p.z.fill(0.0)
            val state = State(p, boundary, 0.9, firstBody = 27)
            val own = NeighbourLists.of(state)
            val near = NeighbourLists.of(state, Neighbours.Within(2.5))
            for (i in 0 until 27) {
                val all = distances(state, i)
                assertEquals(all.count { it <= 2.5 }, near.count(i), "$k")
                assertEquals(Neighbours.SolidAngle.count(all, all.size, state.dimensions), own.count(i), "$k $i")
                for (lists in listOf(own, near)) {
                    for (n in 0 until lists.count(i)) {
                        val d = DoubleArray(3) { lists.component(i, n, it) }
                        assertEquals(all[n], sqrt(d.sumOf { it * it }), 1e-12, "$k $i")
                    }
                }
            }
        }
    }

    @Test
    fun `crystals of one cell have the order of larger ones`() {
        val a = sqrt(2.0)
        val sites = arrayOf(
            doubleArrayOf(0.01, 0.01, 0.01),
            doubleArrayOf(0.5 * a, 0.5 * a, 0.01),
            doubleArrayOf(0.5 * a, 0.01, 0.5 * a),
            doubleArrayOf(0.01, 0.5 * a, 0.5 * a),
        ).map { d -> DoubleArray(3) { (if (d[it] < 0.1) 0.0 else d[it]) - a / 2 + 0.01 } }.toTypedArray()
        val cell = State(population(*sites), Periodic(Box.centred(a, a, a)), 0.0)
        val lists = NeighbourLists.of(cell)
        val order = BondOrder(cell, lists)
        for (i in 0 until 4) {
            assertEquals(12, lists.count(i))
            assertEquals(0.57452, order.q6[i], 1e-5)
            assertEquals(0.19094, order.q4[i], 1e-5)
        }
        // One sphere in a cube is the simple cubic lattice, whose 6 neighbours are its own images.
        val one = State(population(DoubleArray(3)), Periodic(Box.centred(1.0, 1.0, 1.0)), 0.0)
        val cubic = NeighbourLists.of(one, Neighbours.Within(1.1))
        assertEquals(6, cubic.count(0))
        assertEquals(0.35355, BondOrder(one, cubic).q6[0], 1e-5)
        assertEquals(listOf(true, true, true), Clusters.ofNeighbours(one, cubic, booleanArrayOf(true)).spans)
        // Two discs in a rectangle are the hexagonal lattice.
        val row = sqrt(3.0)
        val discs = population(doubleArrayOf(-0.4, -0.8, 0.0), doubleArrayOf(0.1, -0.8 + row / 2, 0.0))
        val plane = State(discs, Periodic(Box.flat(1.0, row)), 0.0)
        val six = NeighbourLists.of(plane)
        assertEquals(listOf(6, 6), listOf(six.count(0), six.count(1)))
        assertEquals(1.0, HexaticOrder(plane, six).ofAll, 1e-9)
    }

    @Test
    fun `clusters are linked through any image`() {
        // A sphere that touches its own image spans; two in a thin box are linked by the nearer side only.
        val one = State(population(DoubleArray(3)), Periodic(Box.centred(5.0, 1.05, 5.0)), 0.0)
        assertEquals(listOf(false, true, false), Clusters.byGap(one, 0.1).spans)
        assertTrue(Clusters.byGap(one, 0.01).spans.none { it })
        val two = State(
            population(DoubleArray(3), doubleArrayOf(0.0, 0.9, 0.0)),
            Periodic(Box.centred(5.0, 2.2, 5.0)),
            0.0,
        )
        assertEquals(listOf(false, false, false), Clusters.byGap(two, 0.0).spans)
        assertEquals(listOf(2), Clusters.byGap(two, 0.0).sizes.toList())
        assertEquals(listOf(false, true, false), Clusters.byGap(two, 0.35).spans)
    }

    @Test
    fun `contact values of particles without correlation are 1 in thin boxes too`() {
        val values = DoubleArray(40) { seed ->
            val boundary: BoundaryConditions = Periodic(Box.centred(12.0, 12.0, 1.3))
            ContactValues().of(uniform(400, boundary, seed + 1L, 0.5))[0]
        }
        val mean = values.average()
        val error = sqrt(values.sumOf { (it - mean) * (it - mean) } / values.size / (values.size - 1))
        assertTrue(abs(mean - 1) < 3 * error && error < 0.03) { "$mean ± $error" }
        val thin = uniform(400, Periodic(Box.centred(12.0, 12.0, 1.0)), 1, 0.5)
        assertThrows(IllegalArgumentException::class.java) { ContactValues().of(thin) }
    }

    @Test
    fun `the first minimum of g is not sought where the box ends before it`() {
        val state = uniform(400, Periodic(Box.centred(12.0, 12.0, 3.0)), 1, 0.5)
        val refused = assertThrows(IllegalArgumentException::class.java) { Neighbours.toFirstMinimum(state) }
        assertTrue("half its shortest edge" in refused.message!!) { refused.message }
    }
}
