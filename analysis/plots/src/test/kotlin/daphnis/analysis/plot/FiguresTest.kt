package daphnis.analysis.plot

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.cbrt
import kotlin.math.pow

class FiguresTest {
    /** Relative luminance of `#rrggbb`, IEC 61966-2-1. */
    private fun luminance(colour: String): Double {
        val parts = listOf(1, 3, 5).map { colour.substring(it, it + 2).toInt(16) / 255.0 }
        val linear = parts.map { if (it <= 0.04045) it / 12.92 else ((it + 0.055) / 1.055).pow(2.4) }
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }

    @Test
    fun `the first four colours differ in lightness, and none is lost on white`() {
        val lightness = Figures.COLOURS.take(4).map { 116 * cbrt(luminance(it)) - 16 }
        for ((darker, lighter) in lightness.zipWithNext()) assertTrue(lighter - darker >= 8) { "$lightness" }
        // WCAG 2.1, 1.4.11: 3 to 1 for graphics.
        for (colour in Figures.COLOURS) assertTrue(1.05 / (luminance(colour) + 0.05) >= 3) { colour }
    }

    @Test
    fun `curves differ in pattern as well as in colour`() {
        val x = DoubleArray(50) { it.toDouble() }
        fun drawn(count: Int) = Figures.svg(
            Chart.lines(
                List(count) { k ->
                    Curve(
                        "c$k",
                        x,
                        DoubleArray(50) {
                            it +
                                10.0 * k
                        },
                    )
                },
                "x",
                "y",
            ),
        )
        assertFalse("stroke-dasharray" in drawn(1))
        // The first is solid; each other has its pattern, in the legend too.
        for (n in 2..6) {
            val patterns = Regex("stroke-dasharray=\"([^\"]*)\"").findAll(drawn(n)).map { it.groupValues[1] }.toSet()
            assertEquals(n - 1, patterns.size) { "$patterns" }
        }
    }

    @Test
    fun `a chart of a single point shows it`() {
        val svg = Figures.svg(Chart.lines(listOf(Curve("a", doubleArrayOf(1.0), doubleArrayOf(2.0))), "x", "y"))
        assertTrue("<circle" in svg && Figures.COLOURS[0] in svg) { svg }
    }

    @Test
    fun `values that spread over more than a factor of five, all positive, go on a logarithmic axis`() {
        assertTrue(Chart.isWide(listOf(1.0, 6.0)))
        assertFalse(Chart.isWide(listOf(1.0, 4.0)))
        assertFalse(Chart.isWide(listOf(0.0, 6.0)))
        assertFalse(Chart.isWide(listOf(-6.0, 6.0)))
        assertFalse(Chart.isWide(emptyList()))
        assertTrue(Chart.isWide(listOf(1.0, Double.NaN, 6.0)))
        // One value at the start of a run is no reason.
        assertFalse(Chart.isWide(listOf(0.1) + List(99) { 10.0 }))
    }
}
