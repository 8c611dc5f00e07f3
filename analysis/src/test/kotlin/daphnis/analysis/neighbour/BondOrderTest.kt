package daphnis.analysis.neighbour

import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

class BondOrderTest {
    /** [cells] copies along each axis of a cell with the [edges] and the [sites], as shares of these. */
    private fun crystal(
        edges: List<Double>,
        sites: List<List<Double>>,
        vararg cells: Int = intArrayOf(4, 4, 4),
    ): State {
        val all = ArrayList<DoubleArray>()
        for (i in 0 until cells[0]) {
            for (j in 0 until cells[1]) {
                for (k in 0 until cells[2]) {
                    for (s in sites) {
                        all += DoubleArray(3) { (s[it] + intArrayOf(i, j, k)[it] - cells[it] / 2.0 + 1e-3) * edges[it] }
                    }
                }
            }
        }
        val zero = DoubleArray(all.size)
        val x = List(3) { axis -> DoubleArray(all.size) { all[it][axis] } }
        val half = DoubleArray(all.size) { 0.5 }
        val box = Box.centred(cells[0] * edges[0], cells[1] * edges[1], cells[2] * edges[2])
        return State(
            Population(x[0], x[1], x[2], zero, zero.copyOf(), zero.copyOf(), half, half.copyOf()),
            Periodic(box),
            0.0,
        )
    }

    private fun fcc(vararg cells: Int = intArrayOf(4, 4, 4)) = sqrt(2.0).let { a ->
        crystal(
            listOf(a, a, a),
            listOf(listOf(0.0, 0.0, 0.0), listOf(0.5, 0.5, 0.0), listOf(0.5, 0.0, 0.5), listOf(0.0, 0.5, 0.5)),
            *cells,
        )
    }

    private fun hcp() = crystal(
        listOf(1.0, sqrt(3.0), sqrt(8.0 / 3)),
        listOf(listOf(0.0, 0.0, 0.0), listOf(0.5, 0.5, 0.0), listOf(0.0, 1.0 / 3, 0.5), listOf(0.5, 5.0 / 6, 0.5)),
    )

    private fun bcc() = (2 / sqrt(3.0)).let { a ->
        crystal(listOf(a, a, a), listOf(listOf(0.0, 0.0, 0.0), listOf(0.5, 0.5, 0.5)))
    }

    @Test
    fun `crystals have the values of Steinhardt, Nelson and Ronchetti, by solid angle and by a distance`() {
        val known = listOf(
            Triple(fcc(), 1.2, listOf(0.19094, 0.57452, -0.01316, 12.0)),
            Triple(hcp(), 1.2, listOf(0.09722, 0.48476, -0.01244, 12.0)),
            Triple(bcc(), 1.3, listOf(0.03637, 0.51069, 0.01316, 14.0)),
        )
        for ((state, reach, values) in known) {
            for (rule in listOf(Neighbours.SolidAngle, Neighbours.Within(reach), Neighbours.toFirstMinimum(state))) {
                val lists = NeighbourLists.of(state, rule)
                val order = BondOrder(state, lists)
                for (i in 0 until state.population.size) {
                    assertEquals(values[3].toInt(), lists.count(i))
                    assertEquals(values[0], order.q4[i], 1e-5)
                    assertEquals(values[1], order.q6[i], 1e-5)
                    assertEquals(values[2], order.w6[i], 1e-5)
                }
                // In a Bravais lattice all surroundings are alike; in hcp the two kinds are mirrored.
                if (state !== known[1].first) assertEquals(order.q6[5], order.averagedQ6[5], 1e-9)
                assertEquals(order.q4[7], order.averagedQ4[7], 1e-9)
                assertTrue(order.solidLike().all { it })
            }
        }
    }

    @Test
    fun `random spheres are not solid-like, and have small q that an average makes smaller`() {
        val state = uniform(2000, Periodic(Box.centred(12.0, 12.0, 12.0)))
        val order = BondOrder(state, NeighbourLists.of(state))
        assertTrue(order.solidLike().count { it } < 20)
        assertTrue(order.averagedQ6.average() < 0.7 * order.q6.average())
    }

    @Test
    fun `it is the same in a turned crystal, through faces, and for images that slide`() {
        val state = fcc()
        val p = state.population
        val lists = NeighbourLists.of(state)
        // Sheared by a whole box, an image is where it was.
        val edge = state.boundary.box.length(0)
        val sheared = State(p, LeesEdwards(state.boundary.box, 1.0), 1.0)
        assertEquals(0.0, sheared.boundary.shear!!.offset(1.0) % edge, 1e-9)
        val order = BondOrder(state, lists)
        val slid = BondOrder(sheared, NeighbourLists.of(sheared))
        for (i in 0 until p.size) assertEquals(order.q6[i], slid.q6[i], 1e-9)
        // Y_lm of a turned set has the same lengths: of open faces, so that the box need not turn.
        val (c, s) = listOf(Math.cos(0.7), Math.sin(0.7))
        val open = State(p, BoundaryConditions.open(), 0.0)
        val turned = Population(
            DoubleArray(p.size) { c * p.x[it] - s * p.z[it] },
            p.y,
            DoubleArray(p.size) { s * p.x[it] + c * p.z[it] },
            p.vx,
            p.vy,
            p.vz,
            p.radius,
            p.mass,
        )
        val plain = BondOrder(open, NeighbourLists.of(open, Neighbours.Within(1.1)))
        val other = State(turned, BoundaryConditions.open(), 0.0).let {
            BondOrder(it, NeighbourLists.of(it, Neighbours.Within(1.1)))
        }
        for (i in 0 until p.size) {
            assertEquals(plain.q4[i], other.q4[i], 1e-9)
            assertEquals(plain.w6[i], other.w6[i], 1e-9)
        }
    }

    @Test
    fun `neighbours are given from both sides, nearest first, and bodies are none`() {
        val p = uniform(200, Periodic(Box.centred(6.0, 6.0, 6.0))).population
        val state = State(p, Periodic(Box.centred(6.0, 6.0, 6.0)), 0.0, firstBody = 190)
        val lists = NeighbourLists.of(state, Neighbours.Within(1.5))
        for (i in 0 until 200) {
            fun length(k: Int) = (0..2).sumOf { lists.component(i, k, it).let { d -> d * d } }
            for (k in 0 until lists.count(i)) {
                assertTrue(i < 190 && lists.neighbour(i, k) < 190)
                if (k > 0) assertTrue(length(k) >= length(k - 1))
                val j = lists.neighbour(i, k)
                val back = (0 until lists.count(j)).filter { lists.neighbour(j, it) == i }
                assertTrue(
                    back.any { b ->
                        (0..2).all {
                            abs(lists.component(j, b, it) + lists.component(i, k, it)) <
                                1e-12
                        }
                    },
                )
            }
        }
        assertTrue(BondOrder(state, lists).q6[195].isNaN())
        val two = uniform(2, state.boundary)
        assertThrows(IllegalArgumentException::class.java) { NeighbourLists.of(two, Neighbours.Within(97.0)) }
        assertThrows(IllegalArgumentException::class.java) { Neighbours.Within(0.0) }
        assertThrows(IllegalArgumentException::class.java) { HexaticOrder(state, lists) }
    }

    @Test
    fun `a hexagonal lattice of discs has a six-fold order of 1, however it is turned, random discs little`() {
        val n = 12
        val row = sqrt(3.0) / 2
        val boundary = Periodic(Box.flat(n.toDouble(), n * row))
        fun at(values: (Int) -> Double) = DoubleArray(n * n) { values(it) }
        val zero = DoubleArray(n * n)
        val x = at { (it % n) + (if (it / n % 2 == 0) 0.0 else 0.5) - n / 2.0 + 0.1 }
        val y = at { (it / n + 0.5) * row - n * row / 2 }
        val half = at { 0.5 }
        val state =
            State(
                Population(x, y, zero, zero.copyOf(), zero.copyOf(), zero.copyOf(), half, half.copyOf()),
                boundary,
                0.0,
            )
        for (rule in listOf(Neighbours.SolidAngle, Neighbours.Within(1.3), Neighbours.toFirstMinimum(state))) {
            val order = HexaticOrder(state, NeighbourLists.of(state, rule))
            assertTrue(order.modulus.all { abs(it - 1) < 1e-9 }) { "$rule ${order.modulus.toList().take(5)}" }
            assertEquals(1.0, order.ofAll, 1e-9)
        }
        val random = SeededRandom(3)
        fun anywhere(edge: Double) = DoubleArray(400) { random.nextDouble(-edge / 2, edge / 2) }
        val none = DoubleArray(400)
        val one = DoubleArray(400) { 0.1 }
        val gas = State(
            Population(
                anywhere(12.0),
                anywhere(12.0),
                none,
                none.copyOf(),
                none.copyOf(),
                none.copyOf(),
                one,
                one.copyOf(),
            ),
            Periodic(Box.flat(12.0, 12.0)),
            0.0,
        )
        val order = HexaticOrder(gas, NeighbourLists.of(gas))
        assertTrue(order.modulus.average() in 0.3..0.5 && order.ofAll < 0.15) {
            "${order.modulus.average()} ${order.ofAll}"
        }
        assertThrows(IllegalArgumentException::class.java) { BondOrder(gas, NeighbourLists.of(gas)) }
    }
}
