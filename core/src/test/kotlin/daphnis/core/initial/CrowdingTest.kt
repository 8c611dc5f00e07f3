package daphnis.core.initial

import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.population.Population
import daphnis.core.search.Overlap
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class CrowdingTest {
    private val walls = BooleanArray(3) { true }

    @Test
    fun `what no search can place is said before one is begun`() {
        fun at(count: Int, box: Box, walled: BooleanArray = BooleanArray(3)) =
            assertThrows(PlacementException::class.java) {
                Crowding.check(DoubleArray(count) { 0.5 }, box, walled)
            }.message.orEmpty()
        assertTrue("0.7405 at most" in at(1500, Box.centred(10.0, 10.0, 10.0)))
        assertTrue("jam at 0.384" in at(2000, Box.centred(14.0, 14.0, 14.0)))
        // 120 discs of diameter 1 in 10 x 10 cover 0.94 of it.
        assertTrue("0.9069 is the most" in at(120, Box.centred(10.0, 10.0, 1.01), booleanArrayOf(false, false, true)))
        assertTrue("between the walls along y" in at(1, Box.centred(10.0, 0.9, 10.0), walls))
        // What is possible, if hard to find, is left to the search.
        Crowding.check(DoubleArray(900) { 0.5 }, Box.centred(10.0, 10.0, 10.0), BooleanArray(3))
        Crowding.check(DoubleArray(110) { 0.5 }, Box.centred(10.0, 10.0, 1.01), booleanArrayOf(false, false, true))
        Crowding.check(DoubleArray(1) { 0.5 }, Box.centred(1.01, 1.01, 1.01), walls)
        Crowding.check(DoubleArray(0), Box.centred(1.0, 1.0, 1.0), walls)
    }

    @Test
    fun `a search that finds places only now and then ends`() {
        fun place(vainPerSphere: Long) = RandomPlacement(200_000, emptyList(), 1, null, 20_000, vainPerSphere)
            .place(DoubleArray(800) { 0.5 }, Box.centred(11.0, 11.0, 11.0), BooleanArray(3), SeededRandom(1))
        // Each sphere finds a place, so the bound on the tries for one is not met; all together take some 40,000.
        assertEquals(800, place(1000).x.size)
        val message = assertThrows(PlacementException::class.java) { place(1) }.message.orEmpty()
        assertTrue("of 800 spheres found a place in 10000 tries" in message) { message }
    }

    @Test
    fun `a cubic lattice between walls takes one, two, three and nine spheres`() {
        for (count in listOf(1, 2, 3, 9)) {
            for (box in listOf(
                Box.centred(10.0, 10.0, 10.0),
                Box.centred(40.0, 40.0, 1.5),
                Box.centred(1.5, 30.0, 1.5),
            )) {
                val radii = DoubleArray(count) { 0.5 }
                val p = LatticePlacement(Lattice.SIMPLE_CUBIC).place(radii, box, walls, SeededRandom(1))
                val none = DoubleArray(count)
                val population = Population(p.x, p.y, p.z, none, none.copyOf(), none.copyOf(), radii, radii.copyOf())
                assertEquals(0.0, Overlap.deepest(population, Open, 0.0).depth)
                for ((axis, places) in listOf(p.x, p.y, p.z).withIndex()) {
                    for (q in places) {
                        assertTrue(
                            q - 0.5 >= box.lower(axis) - 1e-12 && q + 0.5 <= box.upper(axis) + 1e-12,
                        ) { "$count at $q" }
                    }
                }
            }
        }
        val alone = LatticePlacement(Lattice.SIMPLE_CUBIC).place(
            DoubleArray(1) {
                0.5
            },
            Box(1.0, 1.0, 1.0, 4.0, 4.0, 4.0),
            walls,
            SeededRandom(1),
        )
        assertEquals(listOf(2.5, 2.5, 2.5), listOf(alone.x[0], alone.y[0], alone.z[0]))
    }

    @Test
    fun `a power law of any exponent has finite radii within its limits`() {
        for (q in listOf(1e300, -1e300, 400.0, -400.0, 1.0, 1 + 2.3e-16, 1 - 1.2e-16)) {
            val law = PowerLawSizes(0.1, 1.0, q)
            val random = SeededRandom(3)
            val radii = DoubleArray(2000) { law.draw(random) }.sortedArray()
            assertTrue(radii.all { it in 0.1..1.0 }) { "$q" }
            // Beside exponent 1 the law is that of exponent 1, whose median is the geometric mean.
            if (kotlin.math.abs(q - 1) < 1e-9) assertEquals(0.316, radii[1000], 0.03) { "$q" }
        }
    }
}
