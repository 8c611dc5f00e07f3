package daphnis.analysis.plot

import org.jetbrains.letsPlot.intern.toSpec
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class ChartTest {
    private fun limits(values: DoubleArray): List<*> {
        val spec = Chart.map(
            doubleArrayOf(0.0, 1.0),
            doubleArrayOf(0.0, 1.0),
            values,
            "x",
            "y",
            "autocorrelation A",
        ).toSpec()
        val fill = (spec["scales"] as List<*>).map { it as Map<*, *> }.single { it["aesthetic"] == "fill" }
        assertEquals("autocorrelation A", fill["name"])
        assertEquals(0.0, fill["midpoint"])
        return fill["limits"] as List<*>
    }

    @Test
    fun `the colours of a map have zero in their middle`() {
        assertEquals(listOf(-0.8, 0.8), limits(doubleArrayOf(0.8, 0.1, -0.2, 0.0)))
        assertEquals(listOf(-2.0, 2.0), limits(doubleArrayOf(0.5, 0.1, -2.0, 0.0)))
        assertEquals(listOf(-1.0, 1.0), limits(DoubleArray(4)))
    }
}
