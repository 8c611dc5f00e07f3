package daphnis.analysis.plot

import org.jetbrains.letsPlot.geom.geomLine
import org.jetbrains.letsPlot.gggrid
import org.jetbrains.letsPlot.ggsize
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.label.labs
import org.jetbrains.letsPlot.letsPlot
import org.jetbrains.letsPlot.scale.scaleYLog10
import org.jetbrains.letsPlot.themes.themeMinimal
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
        val figure = gggrid(listOf(temperature(rows, title), collisions(rows)), ncol = 1, align = true) + ggsize(WIDTH, HEIGHT)
        Figures.write(figure, directory, "run", WIDTH, HEIGHT)
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

    private fun temperature(rows: List<Row>, title: String): Plot {
        val data = mapOf("time" to rows.map { it.time }, "temperature" to rows.map { it.temperature })
        val plot = letsPlot(data) + geomLine(color = Figures.INK, size = Figures.LINE) {
            x = "time"
            y = "temperature"
        } +
            labs(title = title, x = "time", y = "granular temperature ⟨c²⟩/3") + look()
        return onSuitableScale(plot, rows.map { it.temperature })
    }

    /** The rate between rows so far apart that there are at most [MOST_BINS] of them, lest the noise of single steps hide it. */
    private fun collisions(rows: List<Row>): Plot {
        val stride = maxOf(1, rows.size / MOST_BINS)
        val pairs = rows.filterIndexed { k, _ -> k % stride == 0 }.zipWithNext().filter { (a, b) -> b.time > a.time && b.particles > 0 }
        // Every collision is one of each of its two spheres.
        val rates = pairs.map { (a, b) -> 2 * (b.collisions - a.collisions) / b.particles / (b.time - a.time) }
        val data = mapOf("time" to pairs.map { (a, b) -> (a.time + b.time) / 2 }, "rate" to rates)
        val plot = letsPlot(data) + geomLine(color = Figures.ACCENT, size = Figures.LINE) {
            x = "time"
            y = "rate"
        } +
            labs(x = "time", y = "collisions of a sphere per unit time") + look()
        return onSuitableScale(plot, rates)
    }

    /** Logarithmic when the values spread over much and are positive; else linear. */
    private fun onSuitableScale(plot: Plot, values: List<Double>): Plot {
        if (values.isEmpty() || values.min() <= 0) return plot
        val low = values.min()
        val high = values.max()
        val room = Math.pow(high / low, ROOM)
        return if (high > LOG_FROM * low) plot + scaleYLog10(limits = low / room to high * room) else plot
    }

    private fun look() = themeMinimal()

    private const val WIDTH = 800
    private const val HEIGHT = 640
    private const val MOST_POINTS = 2000
    private const val MOST_BINS = 150
    private const val LOG_FROM = 5.0
    private const val ROOM = 0.05
}
