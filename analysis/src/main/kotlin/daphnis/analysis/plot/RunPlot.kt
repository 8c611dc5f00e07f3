package daphnis.analysis.plot

import java.nio.file.Files
import java.nio.file.Path

/** The plot at the end of a run: granular temperature, and collisions of a sphere in a unit of time, over time. Needs no display. */
public object RunPlot {
    /**
     * Draws the time series in the file [series] into `run.svg` and `run.png` in [directory], which is made.
     *
     * @param title what stands above, such as the name of the scenario
     * @throws IllegalArgumentException when the series has fewer than two rows
     */
    public fun write(series: Path, directory: Path, title: String) {
        val rows = read(series)
        require(rows.size >= 2) { "the time series has ${rows.size} rows; two are needed" }
        val charts = listOf(temperature(rows, title), collisions(rows))
        Files.createDirectories(directory)
        Files.writeString(directory.resolve("run.svg"), SvgSheet(WIDTH, HEIGHT).also { draw(charts, it) }.toString())
        Files.write(directory.resolve("run.png"), png(charts))
    }

    /**
     * Draws a picture of nothing and forgets it. The first picture takes ten times as long as another, for all that Java loads; another thread can do
     * that while a run begins.
     */
    public fun prepare() {
        val rows = listOf(Row(0.0, 1.0, 0.0, 1.0), Row(1.0, 1.0, 1.0, 2.0))
        png(listOf(temperature(rows, "prepared"), collisions(rows)))
    }

    private fun png(charts: List<LineChart>): ByteArray = try {
        if (System.getProperty(HEADLESS) == null) System.setProperty(HEADLESS, "true")
        Png.encode(ImageSheet(WIDTH, HEIGHT, PNG_SCALE).also { draw(charts, it) }.image)
    } catch (e: LinkageError) {
        throw IllegalStateException("this Java has no library to draw with: ${e.message}", e)
    } catch (e: InternalError) {
        throw IllegalStateException("this Java has no fonts to draw with: ${e.message}", e)
    }

    private fun draw(charts: List<LineChart>, sheet: Sheet) {
        val height = HEIGHT.toDouble() / charts.size
        charts.forEachIndexed { k, chart -> chart.draw(sheet, k * height, WIDTH.toDouble(), height) }
    }

    private class Row(val time: Double, val particles: Double, val collisions: Double, val temperature: Double)

    private fun read(series: Path): List<Row> {
        val lines = Files.readAllLines(series)
        val names = lines.first().split(',')
        fun column(name: String) = names.indexOf(name).also { require(it >= 0) { "the time series has no column $name" } }
        val time = column("time")
        val particles = column("particles")
        val collisions = column("collisions")
        val temperature = column("granular_temperature")
        val all = lines.drop(1).map { it.split(',') }.map { Row(it[time].toDouble(), it[particles].toDouble(), it[collisions].toDouble(), it[temperature].toDouble()) }
        // More points than pixels only cost: keep every k-th, and the last.
        val stride = maxOf(1, all.size / MOST_POINTS)
        return all.filterIndexed { k, _ -> k % stride == 0 || k == all.lastIndex }
    }

    private fun temperature(rows: List<Row>, title: String): LineChart {
        val values = rows.map { it.temperature }
        return LineChart(title, "time", "granular temperature ⟨c²⟩/3", rows.map { it.time }, values, Figures.INK, spreads(values))
    }

    /** The rate between rows so far apart that there are at most [MOST_BINS] of them, lest the noise of single steps hide it. */
    private fun collisions(rows: List<Row>): LineChart {
        val stride = maxOf(1, rows.size / MOST_BINS)
        val pairs = rows.filterIndexed { k, _ -> k % stride == 0 }.zipWithNext().filter { (a, b) -> b.time > a.time && b.particles > 0 }
        // Every collision is one of each of its two spheres.
        val rates = pairs.map { (a, b) -> 2 * (b.collisions - a.collisions) / b.particles / (b.time - a.time) }
        val times = pairs.map { (a, b) -> (a.time + b.time) / 2 }
        return LineChart("", "time", "collisions of a sphere per unit time", times, rates, Figures.ACCENT, spreads(rates))
    }

    /** Whether the values are positive and spread over so much that they need a logarithmic axis. */
    private fun spreads(values: List<Double>): Boolean = values.isNotEmpty() && values.min() > 0 && values.max() > LOG_FROM * values.min()

    private const val WIDTH = 800
    private const val HEIGHT = 640
    private const val MOST_POINTS = 2000
    private const val MOST_BINS = 150
    private const val LOG_FROM = 5.0
    private const val PNG_SCALE = 2
    private const val HEADLESS = "java.awt.headless"
}
