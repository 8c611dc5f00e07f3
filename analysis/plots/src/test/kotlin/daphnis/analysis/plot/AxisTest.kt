package daphnis.analysis.plot

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class AxisTest {
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
