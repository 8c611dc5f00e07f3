package daphnis.core.initial

import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.population.Population
import daphnis.core.search.Overlap
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

class SetupTest {
    @Test
    fun `a seed means the same numbers for good`() {
        // Computed with an independent implementation of SplitMix64 and xoshiro256++ (Python integers).
        val random = SeededRandom(1)
        assertEquals(listOf(EXPECTED_1, EXPECTED_2, EXPECTED_3), List(3) { random.nextLong() })
    }

    @Test
    fun `uniform and normal numbers have their moments`() {
        val random = SeededRandom(11)
        val n = 200_000
        val uniform = DoubleArray(n) { random.nextDouble() }
        assertTrue(uniform.all { it >= 0 && it < 1 })
        assertEquals(0.5, uniform.average(), 4 / sqrt(12.0 * n))
        val normal = DoubleArray(n) { random.nextGaussian() }
        assertEquals(0.0, normal.average(), 4 / sqrt(n.toDouble()))
        assertEquals(1.0, normal.map { it * it }.average(), 4 * sqrt(2.0 / n))
        assertEquals(3.0, normal.map { it * it * it * it }.average(), 4 * sqrt(96.0 / n))
        val counts = IntArray(7)
        repeat(70_000) { counts[random.nextInt(7)]++ }
        assertTrue(counts.all { abs(it - 10_000) < 400 }) { counts.toList().toString() }
    }

    @Test
    fun `a power law has the mean radius of its formula and keeps its limits`() {
        val n = 200_000
        for (q in listOf(3.0, 1.0, 2.0)) {
            val radii = PowerLawSizes(0.1, 1.0, q).radii(n, SeededRandom(4))
            assertTrue(radii.all { it in 0.1..1.0 })
            // ⟨r⟩ = ∫ r^(1−q) / ∫ r^−q between the limits.
            val mean = integral(1 - q) / integral(-q)
            assertEquals(mean, radii.average(), 0.01 * mean) { "exponent $q" }
        }
    }

    private fun integral(power: Double): Double = if (power == -1.0) {
        Math.log(10.0)
    } else {
        (1 - Math.pow(0.1, power + 1)) / (power + 1)
    }

    @Test
    fun `a log-normal law has its median, and a list repeats`() {
        val radii = LogNormalSizes(0.5, 0.3, 0.1, 2.0).radii(50_001, SeededRandom(4)).sortedArray()
        assertEquals(0.5, radii[25_000], 0.01)
        assertTrue(radii.first() >= 0.1 && radii.last() <= 2.0)
        assertEquals(listOf(1.0, 2.0, 1.0), ListedSizes(doubleArrayOf(1.0, 2.0)).radii(3, SeededRandom(1)).toList())
        assertTrue(LogNormalSizes(1.0, 50.0, 1.0, 1.0).draw(SeededRandom(1)) == 1.0)
    }

    private fun place(
        method: Placement,
        radii: DoubleArray,
        box: Box,
        walled: BooleanArray = BooleanArray(3),
    ): Population {
        val p = method.place(radii, box, walled, SeededRandom(2))
        val none = DoubleArray(radii.size)
        return Population(p.x, p.y, p.z, none, none.copyOf(), none.copyOf(), radii, DoubleArray(radii.size) { 1.0 })
    }

    @Test
    fun `random placement reaches a filling factor of 0_35 without overlap`() {
        val box = Box.centred(12.0, 12.0, 12.0)
        val count = (0.35 * box.volume / (Math.PI / 6)).toInt()
        val p = place(RandomPlacement(), DoubleArray(count) { 0.5 }, box)
        assertEquals(0.0, Overlap.deepest(p, Periodic(box), 0.0).depth)
    }

    @Test
    fun `random placement takes sizes 1 to 30, flat boxes and walls`() {
        val box = Box.centred(20.0, 20.0, 2.2)
        val radii = PowerLawSizes(1.0 / 30, 1.0, 3.0).radii(3000, SeededRandom(3))
        assertEquals(0.0, Overlap.deepest(place(RandomPlacement(), radii, box), Periodic(box), 0.0).depth)
        val p = place(RandomPlacement(), radii, box, BooleanArray(3) { true })
        assertEquals(0.0, Overlap.deepest(p, Walls(box), 0.0).depth)
        for (k in 0 until p.size) assertTrue(p.z[k] - p.radius[k] >= -1.1 && p.z[k] + p.radius[k] <= 1.1)
    }

    @Test
    fun `what cannot be placed is refused`() {
        val box = Box.centred(6.0, 6.0, 6.0)
        assertThrows(PlacementException::class.java) { place(RandomPlacement(2000), DoubleArray(250) { 0.5 }, box) }
        assertThrows(PlacementException::class.java) {
            place(RandomPlacement(), DoubleArray(1) { 4.0 }, box, BooleanArray(3) { true })
        }
        assertThrows(PlacementException::class.java) { place(LatticePlacement(), DoubleArray(400) { 0.5 }, box) }
    }

    @Test
    fun `lattices reach 0_6 and more, with vacancies and between walls`() {
        val box = Box.centred(10.0, 10.0, 10.0)
        for (count in listOf(1, 2, 13, 500, 1372)) {
            val radius = 0.5 * Math.cbrt(0.6 * 6 / Math.PI * box.volume / 1372)
            assertEquals(
                0.0,
                Overlap.deepest(
                    place(
                        LatticePlacement(),
                        DoubleArray(count) {
                            radius
                        },
                        box,
                    ),
                    Periodic(box),
                    0.0,
                ).depth,
            ) { "$count" }
        }
        for (lattice in Lattice.entries.filter { !it.isPlane }) {
            val p = place(LatticePlacement(lattice), DoubleArray(400) { 0.5 }, box, BooleanArray(3) { true })
            assertEquals(0.0, Overlap.deepest(p, Open, 0.0).depth)
            for (k in 0 until p.size) {
                assertTrue(abs(p.x[k]) <= 4.5 + 1e-12 && abs(p.y[k]) <= 4.5 + 1e-12 && abs(p.z[k]) <= 4.5 + 1e-12)
            }
        }
    }

    private companion object {
        const val EXPECTED_1 = -3475142291704528229L
        const val EXPECTED_2 = -4665094578477473651L
        const val EXPECTED_3 = 1847458086238483744L
    }
}
