package daphnis.core.initial

import daphnis.core.boundary.Box
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

class LatticePlacementTest {
    private fun place(lattice: Lattice, n: Int, box: Box, radius: Double, vacancies: Double = 0.0, seed: Long = 1) =
        LatticePlacement(lattice, vacancies)
            .place(DoubleArray(n) { radius }, box, BooleanArray(3), SeededRandom(seed))

    /** How many spheres are nearer than [within] to each, through faces too. */
    private fun neighbours(p: Positions, box: Box, within: Double): List<Int> = p.x.indices.map { i ->
        p.x.indices.count { j ->
            var square = 0.0
            for ((axis, x) in listOf(p.x, p.y, p.z).withIndex()) {
                val d = x[i] - x[j]
                val apart = d - Math.rint(d / box.length(axis)) * box.length(axis)
                square += apart * apart
            }
            i != j && square < within * within
        }
    }

    @Test
    fun `cells that are stretched and sites that stay empty are told`() {
        val cube = Box.centred(10.0, 10.0, 10.0)
        fun remark(lattice: Lattice, n: Int, vacancies: Double = 0.0, box: Box = cube) =
            LatticePlacement(lattice, vacancies).remark(DoubleArray(n) { 0.1 }, box, BooleanArray(3))
        assertNull(remark(Lattice.FACE_CENTRED_CUBIC, 1372))
        assertNull(remark(Lattice.BODY_CENTRED_CUBIC, 1458))
        assertNull(remark(Lattice.FACE_CENTRED_CUBIC, 1358, 0.01))
        val told = remark(Lattice.BODY_CENTRED_CUBIC, 1372)!!
        assertTrue("10 × 10 × 7 cells of body centred cubic, stretched 1.00 : 1.00 : 1.43; 28 of 1400 sites" in told) {
            told
        }
        assertTrue("sites are empty" in remark(Lattice.FACE_CENTRED_CUBIC, 1372, 0.01)!!)
    }

    @Test
    fun `the stretch of a lattice of discs is that of the better of its two ways to lie`() {
        fun remark(n: Int) = LatticePlacement(Lattice.HEXAGONAL).remark(
            DoubleArray(n) { 0.1 },
            Box.flat(10.0, 10.0),
            BooleanArray(3),
        )
        // 100 in a square lie in ten rows of ten, √3/2 apart where they should be: 1 : 2/√3.
        val told = remark(100)!!
        assertTrue("stretched 1.00 : 1.15" in told) { told }
        assertNull(remark(56))
    }

    @Test
    fun `each sphere has the nearest neighbours of its lattice, at the distance of theirs`() {
        val cube = Box.centred(8.0, 8.0, 8.0)
        fun check(lattice: Lattice, n: Int, box: Box, distance: Double, count: Int) {
            val p = place(lattice, n, box, 0.4999 * distance)
            assertEquals(List(n) { 0 }, neighbours(p, box, 0.999 * distance)) { "$lattice" }
            assertEquals(List(n) { count }, neighbours(p, box, 1.001 * distance)) { "$lattice" }
            assertThrows(PlacementException::class.java) { place(lattice, n, box, 0.501 * distance) }
        }
        check(Lattice.SIMPLE_CUBIC, 64, cube, 2.0, 6)
        check(Lattice.FACE_CENTRED_CUBIC, 256, cube, sqrt(2.0), 12)
        check(Lattice.BODY_CENTRED_CUBIC, 128, cube, sqrt(3.0), 8)
        val hexagonal = Box.centred(5.0, 3 * sqrt(3.0), 3 * sqrt(8.0 / 3))
        check(Lattice.HEXAGONAL_CLOSE_PACKED, 4 * 5 * 3 * 3, hexagonal, 1.0, 12)
    }

    @Test
    fun `between walls whole spheres are inside, and touch none`() {
        for (lattice in Lattice.entries.filter { !it.isPlane }) {
            val box = Box.centred(7.0, 8.0, 9.0)
            val p = LatticePlacement(lattice).place(
                DoubleArray(50) {
                    0.6
                },
                box,
                BooleanArray(3) { true },
                SeededRandom(1),
            )
            for ((axis, x) in listOf(p.x, p.y, p.z).withIndex()) {
                assertTrue(x.min() >= box.lower(axis) + 0.6 - 1e-12 && x.max() <= box.upper(axis) - 0.6 + 1e-12)
            }
            assertTrue(neighbours(p, Box.centred(99.0, 99.0, 99.0), 1.2).all { it == 0 })
        }
    }

    @Test
    fun `vacancies are sites of the full lattice, drawn by the seed`() {
        val box = Box.centred(8.0, 8.0, 8.0)
        val full = place(Lattice.FACE_CENTRED_CUBIC, 256, box, 0.5)
        fun sites(p: Positions) = p.x.indices.map { listOf(p.x[it], p.y[it], p.z[it]) }.toSet()
        val some = place(Lattice.FACE_CENTRED_CUBIC, 192, box, 0.5, 0.25)
        assertEquals(192, sites(some).size)
        assertTrue(sites(full).containsAll(sites(some)))
        assertEquals(sites(some), sites(place(Lattice.FACE_CENTRED_CUBIC, 192, box, 0.5, 0.25)))
        assertNotEquals(sites(some), sites(place(Lattice.FACE_CENTRED_CUBIC, 192, box, 0.5, 0.25, seed = 2)))
        // Each half of the box lacks some.
        assertTrue(sites(some).count { it[0] < 0 } in 75..117)
        assertThrows(IllegalArgumentException::class.java) { LatticePlacement(vacancies = 1.0) }
    }
}
