package daphnis.analysis.plot

import daphnis.analysis.series.SeriesTable
import org.jetbrains.letsPlot.gggrid
import org.jetbrains.letsPlot.ggsize
import java.nio.file.Path

/**
 * The plot at the end of a run: granular temperature, and collisions of a particle in a unit of time, over time. Needs
 * no display.
 */
public object RunPlot {
    /**
     * Draws the time series in the file [series] into `run.svg` and `run.png` in [directory], which is made.
     *
     * @param title what stands above, such as the name of the scenario
     * @param scale what the axes count in
     * @throws IllegalArgumentException when the series has fewer than two rows
     * @throws daphnis.core.format.FormatException when the file is no time series
     */
    public fun write(series: Path, directory: Path, title: String, scale: PlotScale) {
        val table = SeriesTable.read(series)
        require(table.size >= 2) { "the time series has ${table.size} rows; two are needed" }
        val plots = SeriesPlots(table, scale)
        val drawn = listOfNotNull(
            plots.temperature()?.let { plots.temperaturePlot(it, title) },
            plots.collisionRate()?.let { plots.ratePlot(it) },
        )
        require(drawn.isNotEmpty()) { "the time series has no granular temperature and no two rows at different times" }
        val figure = gggrid(drawn, ncol = 1, align = true) + ggsize(WIDTH, HEIGHT)
        Figures.write(figure, directory, "run", WIDTH, HEIGHT)
    }

    private const val WIDTH = 800
    private const val HEIGHT = 640
}
