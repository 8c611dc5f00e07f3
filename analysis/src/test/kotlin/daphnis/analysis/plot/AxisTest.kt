package daphnis.analysis.plot

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class AxisTest {
    private fun labels(low: Double, high: Double, logarithmic: Boolean = false) = Axis(low, high, logarithmic).ticks().map { it.label }

    @Test
    fun `marks stand at round numbers with as many places as their step needs`() {
        assertEquals(listOf("0", "5", "10", "15", "20", "25", "30"), labels(0.0, 30.0))
        assertEquals(listOf("0.90", "0.92", "0.94", "0.96", "0.98", "1.00"), labels(0.9, 1.0))
        assertEquals(listOf("-1.0", "-0.5", "0", "0.5", "1.0"), labels(-1.2, 1.2))
        assertEquals(listOf("1.7e-4", "1.8e-4", "1.9e-4", "2.0e-4"), labels(1.65e-4, 2.05e-4))
        assertEquals(listOf("0", "1e6", "2e6", "3e6", "4e6", "5e6"), labels(0.0, 5.5e6))
    }

    @Test
    fun `a logarithmic axis is marked at powers of ten, a short one between them too`() {
        assertEquals(listOf("1e-4", "0.001", "0.01", "0.1", "1"), labels(1e-4, 1.0, true))
        assertEquals(listOf("1", "2", "5", "10", "20"), labels(0.9, 30.0, true))
        assertTrue(labels(1e-40, 1e40, true).size in 4..11)
        assertEquals(listOf("3.00", "3.02", "3.04", "3.06", "3.08", "3.10"), labels(3.0, 3.1, true))
    }

    @Test
    fun `an end is at 0 or 1 and a value between where it belongs`() {
        val linear = Axis(-2.0, 6.0, false)
        assertEquals(listOf(0.0, 0.25, 1.0), listOf(-2.0, 0.0, 6.0).map { linear.fraction(it) })
        val logarithmic = Axis(0.01, 100.0, true)
        assertEquals(0.5, logarithmic.fraction(1.0), 1e-12)
        assertEquals(0.5, Axis(4.0, 4.0, true).fraction(4.0), 1e-12)
        for (value in listOf(0.0, 4.0, -4.0)) assertEquals(0.5, Axis(value, value, false).fraction(value), 1e-12)
    }
}
