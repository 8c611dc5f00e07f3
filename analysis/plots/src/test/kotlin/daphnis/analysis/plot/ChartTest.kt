package daphnis.analysis.plot

import org.jetbrains.letsPlot.intern.toSpec
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
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
    fun `a logarithmic axis ends a little beyond its points`() {
        val curve = Curve("a", doubleArrayOf(0.5, 1.0, 8.0), doubleArrayOf(1.0, 2.0, 3.0), DoubleArray(3) { 0.1 })
        val spec = Chart.lines(listOf(curve), "x", "y", logX = true).toSpec()
        val x = (spec["scales"] as List<*>).map {
            it as Map<*, *>
        }.single { it["aesthetic"] == "x" && "limits" in it }
        val (low, high) = (x["limits"] as List<*>).map { it as Double }
        assertTrue(low in 0.4..0.499 && high in 8.01..10.0) { "$low to $high" }
    }

    @Test
    fun `the colours of a map have zero in their middle`() {
        assertEquals(listOf(-0.8, 0.8), limits(doubleArrayOf(0.8, 0.1, -0.2, 0.0)))
        assertEquals(listOf(-2.0, 2.0), limits(doubleArrayOf(0.5, 0.1, -2.0, 0.0)))
        assertEquals(listOf(-1.0, 1.0), limits(DoubleArray(4)))
    }
}
