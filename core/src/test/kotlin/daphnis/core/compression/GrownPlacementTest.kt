package daphnis.core.compression

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.initial.PlacementException
import daphnis.core.initial.Positions
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.search.Overlap
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class GrownPlacementTest {
    private fun radii(count: Int, seed: Long? = null): DoubleArray = SeededRandom(seed ?: 0).let { random ->
        DoubleArray(count) {
            if (seed ==
                null
            ) {
                1.0
            } else {
                random.nextDouble(0.3, 1.0)
            }
        }
    }

    private fun boxOf(radii: DoubleArray, filling: Double): Box {
        val edge = Math.cbrt(radii.sumOf { 4.0 / 3 * Math.PI * it * it * it } / filling)
        return Box.centred(edge * 1.1, edge / 1.1, edge)
    }

    private fun place(radii: DoubleArray, box: Box, threads: Int = 1): Positions =
        GrownPlacement(threads).place(radii, box, BooleanArray(3), SeededRandom(5))

    private fun overlap(p: Positions, radii: DoubleArray, box: Box): Double {
        fun rest() = DoubleArray(radii.size)
        val population =
            Population(p.x, p.y, p.z, rest(), rest(), rest(), radii, DoubleArray(radii.size) { 1.0 })
        return Overlap.deepest(population, Periodic(box), 0.0).depth
    }

    @Test
    fun `no spheres overlap, of one size and of many, from loose to dense`() {
        for (filling in listOf(0.1, 0.35, 0.5, 0.58)) {
            for (seed in listOf(null, 3L)) {
                val radii = radii(400, seed)
                val box = boxOf(radii, filling)
                assertEquals(0.0, overlap(place(radii, box), radii, box)) { "$filling, $seed" }
            }
        }
    }

    @Test
    fun `the bits do not depend on threads`() {
        val radii = radii(1500, 7)
        val box = boxOf(radii, 0.52)
        val one = place(radii, box)
        val three = place(radii, box, 3)
        assertArrayEquals(one.x, three.x)
        assertArrayEquals(one.y, three.y)
        assertArrayEquals(one.z, three.z)
    }

    @Test
    fun `loose spheres are placed at random, and none is placed where none is`() {
        val radii = radii(100)
        val box = boxOf(radii, 0.19)
        val random = RandomPlacement().place(radii, box, BooleanArray(3), SeededRandom(5))
        assertArrayEquals(random.y, place(radii, box).y)
        assertEquals(0, place(DoubleArray(0), box).x.size)
    }

    @Test
    fun `what jams, has walls or meets itself is refused`() {
        fun message(radii: DoubleArray, box: Box, walled: BooleanArray = BooleanArray(3)): String =
            assertThrows(PlacementException::class.java) {
                GrownPlacement().place(radii, box, walled, SeededRandom(5))
            }.message!!
        val radii = radii(60)
        assertTrue("that grow jam at 0.65" in message(radii, boxOf(radii, 0.66)))
        assertTrue("growing spheres jam" in message(radii(60, 3), boxOf(radii(60, 3), 0.8)))
        assertTrue("discs that grow jam at 0.9" in message(radii, Box.flat(20.0, 10.4)))
        assertTrue("0.7405" in message(radii, boxOf(radii, 0.75)))
        assertTrue("walls" !in message(radii, boxOf(radii, 0.75)))
        assertTrue("repeats" in message(radii, boxOf(radii, 0.3), BooleanArray(3) { it == 2 }))
        assertTrue("own image along y" in message(radii(1), Box.centred(9.0, 2.0, 9.0)))
    }
}
