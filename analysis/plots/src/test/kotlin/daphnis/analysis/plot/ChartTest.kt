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

    /** Centres of the points of one curve, as places from left and from above. */
    private fun points(svg: String): List<Pair<Double, Double>> = Regex("<circle[^>]*>").findAll(svg)
        .map { it.value }
        .map { c -> listOf("cx", "cy").map { Regex("$it=\"([^\"]*)\"").find(c)!!.groupValues[1].toDouble() } }
        .map { (x, y) -> x to y }
        .toList()

    @Test
    fun `points over logarithmic axes fill the chart`() {
        val x = DoubleArray(13) { it + 1.0 }
        val curve = Curve("a", x, DoubleArray(13) { 100 * x[it] }, DoubleArray(13) { 1.0 })
        val drawn = points(Figures.svg(Chart.lines(listOf(curve), "x", "y", logX = true, logY = true)))
        assertEquals(13, drawn.size)
        val across = drawn.maxOf { it.first } - drawn.minOf { it.first }
        val up = drawn.maxOf { it.second } - drawn.minOf { it.second }
        assertTrue(across > 0.8 * Chart.WIDTH && up > 0.7 * Chart.HEIGHT) { "$across, $up" }
    }

    @Test
    fun `the first curve is drawn over the others`() {
        val x = doubleArrayOf(1.0, 2.0)
        val curves = listOf("first", "second").map { Curve(it, x, x) }
        val data = Chart.lines(curves, "x", "y").toSpec()["data"] as Map<*, *>
        assertEquals(listOf("second", "second", "first", "first"), data["curve"])
    }

    @Test
    fun `numbers at a map have a minus, not a hyphen`() {
        val places = DoubleArray(5) { 50.0 * (it - 2) }
        val values = DoubleArray(25) { 0.01 * (it - 12) }
        val svg = Figures.svg(Chart.map(places, places, values, "x", "y", "A"))
        val words = Regex("<text[^>]*>([^<]*)<").findAll(svg).map { it.groupValues[1].trim() }.toList()
        assertTrue("−100" in words && "−0.10" in words && words.none { "-" in it }) { "$words" }
    }

    @Test
    fun `the colours of a map have zero in their middle`() {
        assertEquals(listOf(-0.8, 0.8), limits(doubleArrayOf(0.8, 0.1, -0.2, 0.0)))
        assertEquals(listOf(-2.0, 2.0), limits(doubleArrayOf(0.5, 0.1, -2.0, 0.0)))
        assertEquals(listOf(-1.0, 1.0), limits(DoubleArray(4)))
    }
}
