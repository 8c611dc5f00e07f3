package daphnis.analysis.plot

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class TicksTest {
    private fun assertPlaces(ticks: Ticks, vararg places: Double) = assertArrayEquals(
        places,
        ticks.places.toDoubleArray(),
        1e-12 * places.maxOf { Math.abs(it) },
    )

    @Test
    fun `a linear axis is marked at round places within it`() {
        val ticks = Ticks.linear(-0.1, 6.0)
        assertPlaces(ticks, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
        assertEquals(listOf("0", "1", "2", "3", "4", "5", "6"), ticks.labels)
        assertEquals(listOf("−0.10", "−0.05", "0", "0.05", "0.10"), Ticks.linear(-0.13, 0.14).labels)
        assertEquals(listOf("3"), Ticks.linear(3.0, 3.0).labels.map { it.removeSuffix(".000") })
    }

    @Test
    fun `an axis from zero ends at a mark that is not below its values`() {
        assertPlaces(Ticks.linearFromZero(1.01), 0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2)
        assertPlaces(Ticks.linearFromZero(1.0), 0.0, 0.2, 0.4, 0.6, 0.8, 1.0)
        for (k in 1..2000) {
            val high = 1e-5 * Math.pow(1.013, k.toDouble())
            val places = Ticks.linearFromZero(high).places
            val step = places[1]
            assertTrue(places[0] == 0.0 && places.last() >= high * (1 - 1e-9) && places.last() < high + step) {
                "$high"
            }
            assertTrue(places.size in 4..9) { "$high: ${places.size}" }
        }
    }

    @Test
    fun `small and large values have a power of ten, never an e`() {
        val small = Ticks.linear(6.5e-4, 9.1e-4)
        val labels = listOf("6.5", "7.0", "7.5", "8.0", "8.5", "9.0").map { "$it · 10⁻⁴" }
        assertEquals(labels, small.labels)
        assertEquals(6.5e-4, small.places[0], 1e-15)
        val large = listOf("0.5", "1.0", "1.5", "2.0", "2.5", "3.0", "3.5").map { "$it · 10⁷" }
        assertEquals(listOf("0") + large, Ticks.linear(0.0, 3.5e7).labels)
    }

    @Test
    fun `a logarithmic axis is marked at powers of ten, and between when it is short`() {
        assertEquals(listOf("10⁻⁴", "0.001", "0.01", "0.1", "1", "10"), Ticks.logarithmic(9e-5, 20.0).labels)
        assertEquals(listOf("0.3", "1", "3", "10"), Ticks.logarithmic(0.28, 24.0).labels)
        assertEquals(listOf("2 · 10⁶", "5 · 10⁶", "10⁷"), Ticks.logarithmic(1.9e6, 1.6e7).labels)
        assertPlaces(Ticks.logarithmic(0.28, 24.0), 0.3, 1.0, 3.0, 10.0)
        // Round-off takes no mark away.
        val first = listOf("1", "3", "10")
        assertEquals(first, Ticks.logarithmic(1.0000000000000002, 12.999999999999998).labels)
        assertEquals(first, Ticks.logarithmic(1.0, 9.999999999999998).labels)
        // Between two steps there are round places of a linear axis.
        val near = Ticks.logarithmic(0.0345, 0.0362)
        assertTrue(near.labels.toSet().size >= 2 && near.places.all { it in 0.0345..0.0362 }) { "${near.labels}" }
        val wide = Ticks.logarithmic(1e-20, 1e20)
        assertTrue(wide.places.size in 4..10) { "${wide.labels}" }
    }
}
