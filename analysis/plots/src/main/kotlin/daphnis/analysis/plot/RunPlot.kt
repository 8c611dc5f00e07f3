package daphnis.analysis.plot

import daphnis.analysis.series.SeriesTable
import daphnis.analysis.table.UnitNames
import daphnis.core.format.FormatException
import daphnis.core.format.WholeFile
import daphnis.core.run.SeriesColumns
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * The plot at the end of a run: granular temperature, and collisions per particle and unit of time, over time. Drawn
 * without the plotting library, whose first picture takes longer than a short run (ADR 126). Needs no display.
 */
public object RunPlot {
    /**
     * Draws the time series in the file [series] into `run.svg` and `run.png` in [directory], which is made.
     *
     * @param title what stands above, such as the name of the scenario
     * @param scale what the axes count in
     * @throws FormatException when the file is no time series, or has too little to draw, such as one row
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(series: Path, directory: Path, title: String, scale: PlotScale) {
        val table = SeriesTable.read(series)
        if (table.size < 2) {
            throw FormatException("the time series has ${if (table.size == 1) "1 row" else "no row"}; two are needed")
        }
        val charts = charts(table, title, scale)
        if (charts.isEmpty()) {
            throw FormatException("the time series has no granular temperature and no two rows at different times")
        }
        Files.createDirectories(directory)
        WholeFile.write(directory.resolve("run.svg"), svg(charts, OF_FILES))
        WholeFile.write(directory.resolve("run.png"), png(charts))
    }

    /**
     * The plot of the file [series] as an SVG for a page, narrow and with large text: it can be read at a width of 300
     * pixels. Null while there is not enough to draw.
     *
     * @throws FormatException when the file is no time series
     */
    @JvmStatic
    public fun svg(series: Path, title: String, scale: PlotScale): String? {
        val table = SeriesTable.read(series)
        if (table.size < 2) return null
        return charts(table, title, scale).takeIf { it.isNotEmpty() }?.let { svg(it, OF_PAGE) }
    }

    /**
     * Draws a picture of nothing and forgets it. The first picture takes ten times as long as another, for all that
     * Java loads; another thread can do that while a run begins.
     */
    @JvmStatic
    public fun prepare() {
        val curve = Curve("", doubleArrayOf(0.0, 1.0), doubleArrayOf(1.0, 2.0))
        val axis = Time("time", 0.0, 1.0)
        png(listOf(chart(curve, "prepared", axis, "", ""), chart(curve, "", axis, "", "")))
    }

    private fun charts(table: SeriesTable, title: String, scale: PlotScale): List<LineChart> {
        val curves = SeriesPlots(table, scale)
        val times = table[SeriesColumns.TIME]
        val time = Time(UnitNames.axis("time", scale.timeName), times.first() / scale.time, times.last() / scale.time)
        return listOfNotNull(
            curves.temperature()?.let { chart(it, title, time, SeriesPlots.TEMPERATURE, scale.temperatureName) },
            curves.collisionRate()?.let {
                chart(it, "", time, SeriesPlots.RATE, scale.rateName, Figures.ACCENT, counted = true)
            },
        )
    }

    /** The axis that both charts have. */
    private class Time(val label: String, val from: Double, val to: Double)

    private fun chart(
        curve: Curve,
        title: String,
        x: Time,
        y: String,
        unit: String,
        colour: String = Figures.INK,
        counted: Boolean = false,
    ): LineChart {
        val log = Chart.isWide(curve.y.asList())
        val label = UnitNames.axis(y, unit) + if (log) " (log scale)" else ""
        return LineChart(title, x.label, label, curve.x.asList(), curve.y.asList(), colour, log, x.from, x.to, counted)
    }

    /** Width and height in points, and sizes of text. */
    private class Layout(val width: Int, val height: Int, val text: LineChart.Text)

    private fun svg(charts: List<LineChart>, layout: Layout): String =
        SvgSheet(layout.width, layout.height).also { draw(charts, it, layout) }.toString()

    private fun png(charts: List<LineChart>): ByteArray = drawing {
        val sheet = ImageSheet(OF_FILES.width, OF_FILES.height, PNG_SCALE)
        Png.encode(sheet.also { draw(charts, it, OF_FILES) }.image)
    }

    private fun draw(charts: List<LineChart>, sheet: Sheet, layout: Layout) {
        val height = layout.height.toDouble() / charts.size
        charts.forEachIndexed { k, it -> it.draw(sheet, k * height, layout.width.toDouble(), height, layout.text) }
    }

    private val OF_FILES = Layout(800, 640, LineChart.Text(11, 13, 16))
    private val OF_PAGE = Layout(380, 600, LineChart.Text(14, 14, 16))
    private const val PNG_SCALE = 2
}
