package daphnis.core.compression

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.initial.PlacementException
import daphnis.core.initial.PlacementProgress
import daphnis.core.initial.PlacementWatcher
import daphnis.core.initial.Positions
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.initial.fillingFactor
import daphnis.core.population.Population
import daphnis.core.search.Overlap
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
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
                val radii = radii(200, seed)
                val box = boxOf(radii, filling)
                assertEquals(0.0, overlap(place(radii, box), radii, box)) { "$filling, $seed" }
            }
        }
    }

    @Test
    fun `the bits do not depend on threads`() {
        val radii = radii(1000, 7)
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
    fun `work has a bound, after which spheres are jammed`() {
        val radii = radii(60, 3)
        val told = assertThrows(PlacementException::class.java) {
            GrownPlacement(1, 300).place(radii, boxOf(radii, 0.8), BooleanArray(3), SeededRandom(5))
        }.message.orEmpty()
        val filling = Regex("growing spheres jam at a filling factor of ([0-9.]+), before 0\\.[78]").find(told)
        assertTrue(filling!!.groupValues[1].toDouble() in 0.55..0.7) { told }
    }

    @Tag("thorough")
    @Test
    fun `spheres grow to a pressure, near the filling factor of equilibrium, with any threads`() {
        fun ofSpheres(x: Double) = (1 + x + x * x - x * x * x) / ((1 - x) * (1 - x) * (1 - x))
        fun ofDiscs(x: Double) = (1 + x * x / 8) / ((1 - x) * (1 - x))
        val cases = listOf(
            Triple(200, Box.centred(20.0, 22.0, 18.0), 6.0),
            Triple(100, Box.centred(20.0, 22.0, 18.0), 1.5),
            Triple(40, Box.centred(3.0, 3.0, 3.0), 3.0),
            Triple(200, Box.flat(30.0, 28.0), 4.0),
        )
        for ((count, box, pressure) in cases) {
            val radii = radii(count)
            val grown = GrownPlacement().placeAtPressure(pressure, radii, box, BooleanArray(3), SeededRandom(3))
            val wide = DoubleArray(count) { radii[it] * grown.factor }
            assertEquals(0.0, overlap(grown.positions, wide, box))
            val filling = fillingFactor(wide, box)
            val fluid = if (box.space.isPlane) ofDiscs(filling) else ofSpheres(filling)
            assertEquals(1.0, (fluid - 1) / (pressure - 1), 0.12) { "$count, $pressure: $filling, $fluid" }
            if (count > 100) continue
            val three = GrownPlacement(3).placeAtPressure(pressure, radii, box, BooleanArray(3), SeededRandom(3))
            assertEquals(grown.factor, three.factor)
            assertArrayEquals(grown.positions.y, three.positions.y)
        }
        fun refused(radii: DoubleArray, walled: Boolean) = assertThrows(PlacementException::class.java) {
            GrownPlacement().placeAtPressure(3.0, radii, cases[0].second, BooleanArray(3) { walled }, SeededRandom(3))
        }.message.orEmpty()
        assertTrue("it takes two" in refused(radii(1), false))
        assertTrue("repeats" in refused(radii(5), true))
    }

    @Test
    fun `who watches is told how far spheres have grown`() {
        val radii = radii(100)
        val parts = ArrayList<Double>()
        val words = ArrayList<String>()
        val watcher = PlacementWatcher { part, what ->
            parts += part
            words += what
        }
        val seen = PlacementProgress.watched(watcher) { place(radii, boxOf(radii, 0.57)) }
        assertTrue(parts.size > 20 && parts.zipWithNext().all { (a, b) -> a < b }) { "$parts" }
        assertTrue(parts.first() < 0.1)
        assertEquals(1.0, parts.last(), 1e-6)
        assertEquals("spheres grow: filling factor 0.5700 of 0.5700", words.last())
        assertTrue("spheres grow: filling factor 0.2" in words.first())
        val count = parts.size
        assertArrayEquals(seen.x, place(radii, boxOf(radii, 0.57)).x)
        assertEquals(count, parts.size) { "nobody watches any more" }
    }

    @Test
    fun `what jams, has walls or meets itself is refused`() {
        fun message(radii: DoubleArray, box: Box, walled: BooleanArray = BooleanArray(3)): String =
            assertThrows(PlacementException::class.java) {
                GrownPlacement().place(radii, box, walled, SeededRandom(5))
            }.message!!
        val radii = radii(60)
        assertTrue("that grow jam at 0.65" in message(radii, boxOf(radii, 0.66)))
        assertTrue("discs that grow jam at 0.9" in message(radii, Box.flat(20.0, 10.4)))
        assertTrue("0.7405" in message(radii, boxOf(radii, 0.75)))
        assertTrue("walls" !in message(radii, boxOf(radii, 0.75)))
        assertTrue("repeats" in message(radii, boxOf(radii, 0.3), BooleanArray(3) { it == 2 }))
        assertTrue("own image along y" in message(radii(1), Box.centred(9.0, 2.0, 9.0)))
    }
}
