package daphnis.analysis.neighbour

import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.hill.HillSheet
import daphnis.core.populationOf
import daphnis.core.search.NearPairs
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

class ClustersTest {
    private val box = Box.centred(10.0, 10.0, 10.0)

    private fun at(vararg places: List<Double>, boundary: BoundaryConditions = Periodic(box), time: Double = 0.0) =
        State(
            populationOf(*places.map { Sphere(it[0], it[1], it[2], 0.0, 0.0, 0.0, r = 0.5) }.toTypedArray()),
            boundary,
            time,
        )

    @Test
    fun `spheres are linked where the gap is small enough, and clusters are numbered from the largest down`() {
        val state = at(
            listOf(0.0, 0.0, 0.0),
            listOf(3.0, 0.0, 0.0),
            listOf(4.05, 0.0, 0.0),
            listOf(4.05, 1.08, 0.0),
            listOf(0.0, 3.0, 0.0),
            listOf(0.0, 4.2, 0.0),
        )
        val found = Clusters.byGap(state, 0.1)
        assertEquals(listOf(3, 1, 1, 1), found.sizes.toList())
        assertEquals(listOf(1, 0, 0, 0, 2, 3), found.label.toList())
        assertEquals(listOf(3, 2, 1), Clusters.byGap(state, 0.21).sizes.toList())
        assertEquals(14.0 / 6, Clusters.byGap(state, 0.21).meanSize, 1e-12)
        assertEquals(6, Clusters.byGap(state, 0.0).sizes.size)
    }

    @Test
    fun `a row of touching spheres along an axis spans, one with a gap does not, nor does a ring`() {
        for (axis in 0..2) {
            fun row(n: Int) = Array(n) { k -> List(3) { if (it == axis) k - 4.5 else 1.0 } }
            val whole = Clusters.byGap(at(*row(10)), 0.01)
            assertEquals(listOf(10), whole.sizes.toList())
            assertEquals(List(3) { it == axis }, whole.spans)
            assertEquals(List(3) { false }, Clusters.byGap(at(*row(9)), 0.01).spans)
        }
        val square = listOf(
            0.0 to 0.0,
            1.0 to 0.0,
            2.0 to 0.0,
            2.0 to 1.0,
            2.0 to 2.0,
            1.0 to 2.0,
            0.0 to 2.0,
            0.0 to 1.0,
        )
        val ring = at(*square.map { (x, y) -> listOf(4.0 + x, 4.0 + y, 0.0) }.toTypedArray())
        val found = Clusters.byGap(ring, 0.01)
        assertEquals(listOf(8), found.sizes.toList())
        assertTrue(found.spans.none { it })
    }

    @Test
    fun `a row across sliding images meets itself only where they stand`() {
        // Images above y have slid by 3 along x: a row that leans by 3 over the box goes on in itself.
        val lean = Array(15) { k -> (-4.9 + k * 10.0 / 15).let { y -> listOf((y + 5) * 0.3, y, 0.0) } }
        val boundary = LeesEdwards(box, 0.3)
        assertEquals(3.0, boundary.shear!!.offset(1.0), 1e-12)
        assertEquals(listOf(false, true, false), Clusters.byGap(at(*lean, boundary = boundary, time = 1.0), 0.1).spans)
        assertTrue(Clusters.byGap(at(*lean), 0.1).spans.none { it })
    }

    @Test
    fun `they are those of a plain search, for any boundary, and bodies are in none`() {
        for (boundary in listOf(Periodic(box), LeesEdwards(box, 0.7), HillSheet(box, 1.0), BoundaryConditions.open())) {
            val p = uniform(300, Periodic(box), 4, 0.3).population
            val state = State(p, boundary, 0.9, firstBody = 290)
            val found = Clusters.byGap(state, 0.35)
            val label = IntArray(300) { it }
            val pairs = NearPairs(p, boundary, 0.9)
            val runs = pairs.runs()
            repeat(60) {
                for (slot in 0 until 300) {
                    pairs.forEach(runs, slot, 1.0) { i, j, dx, dy, dz ->
                        if (maxOf(i, j) < 290 && sqrt(dx * dx + dy * dy + dz * dz) <= 0.95) {
                            label[i] = minOf(label[i], label[j])
                            label[j] = label[i]
                        }
                    }
                }
            }
            val sizes = label.take(290).groupingBy { it }.eachCount().values.sortedDescending()
            assertEquals(sizes, found.sizes.toList())
            assertTrue(
                (0 until 290).all { i ->
                    (0 until i).all {
                        (label[i] == label[it]) ==
                            (found.label[i] == found.label[it])
                    }
                },
            )
            assertTrue(found.label.drop(290).all { it == -1 })
            assertEquals(290, found.particles)
        }
    }

    @Test
    fun `of neighbours only members count`() {
        val state = at(listOf(0.0, 0.0, 0.0), listOf(1.0, 0.0, 0.0), listOf(2.0, 0.0, 0.0))
        val lists = NeighbourLists.of(state, Neighbours.Within(1.1))
        val found = Clusters.ofNeighbours(state, lists, booleanArrayOf(true, false, true))
        assertEquals(listOf(1, 1), found.sizes.toList())
        assertEquals(listOf(0, -1, 1), found.label.toList())
        assertEquals(listOf(3), Clusters.ofNeighbours(state, lists, BooleanArray(3) { true }).sizes.toList())
        assertThrows(IllegalArgumentException::class.java) { Clusters.ofNeighbours(state, lists, BooleanArray(2)) }
        assertThrows(IllegalArgumentException::class.java) { Clusters.byGap(state, -1.0) }
        assertThrows(IllegalArgumentException::class.java) { Clusters.byGap(state, 200.0) }
        assertEquals(0.0, Clusters.ofNeighbours(state, lists, BooleanArray(3)).meanSize)
    }
}
