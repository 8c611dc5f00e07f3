package daphnis.analysis.plot

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ChartTest {
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
        val svg = Figures.svg(Chart.lines(listOf("first", "second").map { Curve(it, x, x) }, "x", "y"))
        assertTrue(svg.lastIndexOf(Figures.COLOURS[0]) > svg.lastIndexOf(Figures.COLOURS[1]))
    }

    @Test
    fun `a bar and a line across are within the chart, on a logarithmic axis too`() {
        val x = doubleArrayOf(1.0, 2.0, 3.0)
        for (log in listOf(false, true)) {
            val curve = Curve("a", x, doubleArrayOf(2.0, 40.0, 3.0), doubleArrayOf(1.9, 9.0, 4.0))
            val svg = Figures.svg(Chart.lines(listOf(curve), "x", "y", logY = log, horizontal = 1.0))
            val heights = Regex("[ML][0-9.]+ ([0-9.]+)").findAll(svg).map { it.groupValues[1].toDouble() }.toList()
            assertTrue(heights.all { it in 0.0..Chart.HEIGHT.toDouble() }) { "$heights" }
            assertTrue(Figures.QUIET in svg && ("(log scale)" in svg) == log)
        }
    }

    @Test
    fun `a line across that a logarithmic axis does not reach is left out, and no point leaves an empty chart`() {
        val far = Curve("a", doubleArrayOf(1.0, 2.0), doubleArrayOf(1e3, 1e5))
        assertFalse(Figures.QUIET in Figures.svg(Chart.lines(listOf(far), "x", "y", logY = true, horizontal = 1.0)))
        val none = Curve("a", doubleArrayOf(1.0), doubleArrayOf(Double.NaN))
        val svg = Figures.svg(Chart.lines(listOf(none), "x", "y", logX = true, logY = true, vertical = 3.0))
        assertFalse("NaN" in svg || "Infinity" in svg) { svg }
    }

    @Test
    fun `a figure draws the same bytes each time, as an SVG and as a PNG`() {
        val x = DoubleArray(50) { it.toDouble() }
        fun figure() = Chart.lines(listOf(Curve("a", x, x, x), Curve("b", x, x)), "x [m]", "y", "title", vertical = 2.0)
        assertEquals(Figures.svg(figure()), Figures.svg(figure()))
        assertTrue(Figures.png(figure()).contentEquals(Figures.png(figure())))
    }

    @Test
    fun `a single value that is thirty times as large as most is a peak`() {
        assertTrue(Chart.hasPeak(List(59) { 1.0 + it % 3 } + 8000.0))
        assertFalse(Chart.hasPeak(List(59) { 1.0 } + 29.0))
        assertFalse(Chart.hasPeak(listOf(0.0, 1.0, 1.0, 8000.0)))
        assertFalse(Chart.hasPeak(listOf(Double.NaN)))
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
        assertEquals("#ffffff", MapChart.colour(0.0))
        assertEquals(Figures.ACCENT, MapChart.colour(1.0))
        assertEquals(Figures.INK, MapChart.colour(-1.0))
        val places = doubleArrayOf(0.0, 1.0)
        fun tiles(vararg values: Double) =
            Figures.svg(Chart.map(places, places, values, "x", "y", "A")).lines().filter { "<rect x" in it }.take(4)
        // The largest of both signs has the whole colour, and the first row is at the bottom.
        val drawn = tiles(0.8, 0.1, -0.2, Double.NaN)
        assertTrue(Figures.ACCENT in drawn[0] && Figures.INK !in drawn.take(3).joinToString())
        assertTrue(Figures.INK in tiles(0.5, 0.1, -2.0, 0.0)[2])
        assertTrue(tiles(0.0, 0.0, 0.0, 0.0).all { "#ffffff" in it })
    }

    @Test
    fun `a title of two lines keeps clear of the numbers, however wide these are`() {
        val y = doubleArrayOf(1e-4, 1.2345e-3)
        val figure = Chart.lines(
            listOf(Curve("a", doubleArrayOf(0.0, 1.0), y)),
            "time",
            "granular temperature ⟨c²⟩/3 [units of length²/time²]",
        )
        val texts = Regex(
            "translate\\(([\\d.]+) [\\d.]+\\)( rotate\\(-90\\))?\" font-size=\"(\\d+)\" " +
                "text-anchor=\"(\\w+)\"[^>]*>([^<]*)<",
        )
            .findAll(Figures.svg(figure, 760, 280)).map { it.groupValues }.toList()
        val font = java.awt.Font("DejaVu Sans", java.awt.Font.PLAIN, 130)
        val title = texts.filter { it[2].isNotEmpty() }.maxOf { it[1].toDouble() + 0.24 * it[3].toInt() }
        val numbers = texts.filter { it[4] == "end" }
        assertTrue(numbers.size >= 3)
        for (number in numbers) {
            val glyphs = font.createGlyphVector(java.awt.font.FontRenderContext(null, true, true), number[5])
            val width = glyphs.logicalBounds.width * number[3].toInt() / 130
            assertTrue(number[1].toDouble() - width > title + 3) { "$number, title to $title" }
        }
    }

    @Test
    fun `the last number below a chart ends on the sheet`() {
        // Among these are ends just behind a number.
        val ends = (0..120).flatMap { k -> listOf(0.044 + 6e-5 * k, 44_000 + 60.0 * k) }
        for (end in ends) {
            val x = DoubleArray(20) { end * it / 19 }
            val svg = Figures.svg(Chart.lines(listOf(Curve("a", x, x)), "x", "y"), 760, 340)
            val below = Regex(
                "translate\\(([\\d.]+) [\\d.]+\\)\" font-size=\"13\" text-anchor=\"middle\"[^>]*>([^<]*)<",
            )
                .findAll(svg).map { it.groupValues }.toList()
            assertTrue(below.size >= 3) { svg }
            val last = below.maxOf { it[1].toDouble() + 13 * TextWidth.of(it[2]) / 2 }
            assertTrue(last < 760) { "$end: $last" }
        }
    }

    @Test
    fun `charts side by side show one range, with the same marks`() {
        fun marks(x: DoubleArray) = Chart.lines(
            listOf(
                Curve(
                    "a",
                    x,
                    DoubleArray(x.size) {
                        it.toDouble()
                    },
                ),
            ),
            "t",
            "y",
            across = listOf(0.0, 40.0),
        )
            .let { Regex("text-anchor=\"middle\"[^>]*>([\\d.]+)<").findAll(Figures.svg(it, 760, 280)) }
            .map { it.groupValues[1] }.toList()
        assertEquals(listOf("0", "5", "10", "15", "20", "25", "30", "35", "40"), marks(doubleArrayOf(0.13, 39.9)))
        assertEquals(marks(doubleArrayOf(0.13, 39.9)), marks(doubleArrayOf(0.0, 40.0)))
    }
}
