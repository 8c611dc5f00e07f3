package daphnis.core.scenario

import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.pow
import kotlin.math.sqrt

/** The length of a step that is chosen, against textbook formulas. */
class FreePathTest {
    private val box = Box.centred(20.0, 30.0, 40.0)

    private fun spheres(vararg radii: Double): Population {
        val none = DoubleArray(radii.size)
        return Population.builder().positions(none, none, none).radii(radii).mass(1.0).build()
    }

    private fun gas(count: Int, radius: Double) = spheres(*DoubleArray(count) { radius })

    private fun assertPath(expected: Double, population: Population) {
        val path = FreePath.length(population, box, Periodic(box))
        assertEquals(expected, path, 1e-12 * expected) { "${population.size} spheres" }
    }

    @Test
    fun `equal spheres move in proportion to the root of mean free path times diameter`() {
        for ((count, radius) in listOf(2_000 to 0.5, 20_000 to 0.5, 9_000 to 0.15, 13_000 to 0.5)) {
            val filling = count * 4 * PI / 3 * radius.pow(3) / 24_000
            val contact = (1 - filling / 2) / (1 - filling).pow(3)
            val freePath = 2 * radius / (6 * sqrt(2.0) * filling * contact)
            assertPath(2.8 * 0.45 * sqrt(freePath * 2 * radius), gas(count, radius))
        }
    }

    @Test
    fun `spheres of two sizes have the mean cross section`() {
        val radii = DoubleArray(4_000) { if (it % 2 == 0) 0.3 else 0.6 }
        val filling = 2_000 * 4 * PI / 3 * (0.3.pow(3) + 0.6.pow(3)) / 24_000
        val contact = (1 - filling / 2) / (1 - filling).pow(3)
        val crossSection = PI * (0.6.pow(2) + 2 * 0.9.pow(2) + 1.2.pow(2)) / 4
        val freePath = 24_000 / (sqrt(2.0) * 4_000 * crossSection * contact)
        assertPath(2.8 * 0.45 * sqrt(freePath * sqrt(crossSection / PI)), spheres(*radii))
    }

    @Test
    fun `spheres in a very thin gas, and specks, move a part of their distance`() {
        val distance = (24_000.0 / 3_000).pow(1.0 / 3)
        assertPath(2.8 * 0.6 * distance, gas(3_000, 1e-3))
        assertPath(2.8 * 0.6 * distance, gas(3_000, 1e-200))
    }

    @Test
    fun `nothing moves farther than half the shortest edge that has images`() {
        assertPath(10.0, gas(1, 0.5))
        assertPath(10.0, gas(0, 0.5))
        assertEquals(2.8 * 0.6 * 24_000.0.pow(1.0 / 3), FreePath.length(gas(1, 0.1), box, Open), 1e-9)
        assertEquals(24_000.0.pow(1.0 / 3), FreePath.length(gas(0, 0.1), box, Open), 1e-9)
    }

    @Test
    fun `edges between walls count as those with images do, and open ones do not`() {
        assertEquals(10.0, FreePath.length(gas(1, 0.5), box, Walls(box)))
        assertEquals(15.0, FreePath.length(gas(1, 0.5), box, Periodic(box, periodicX = false)))
    }

    @Test
    fun `spheres that were removed do not count`() {
        val radii = DoubleArray(4_000) { if (it % 2 == 0) 0.3 else 0.6 }
        val some = spheres(*radii).apply { retain { radius[it] < 0.5 } }
        assertEquals(FreePath.length(gas(2_000, 0.3), box, Periodic(box)), FreePath.length(some, box, Periodic(box)))
    }

    @Test
    fun `overlapping crowds have the path of the densest gas that theory holds for`() {
        val crowded = 0.6
        val contact = (1 - crowded / 2) / (1 - crowded).pow(3)
        val count = 60_000
        val freePath = 24_000 / (sqrt(2.0) * count * PI * contact)
        assertPath(2.8 * 0.45 * sqrt(freePath), gas(count, 0.5))
    }
}
