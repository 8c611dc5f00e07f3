package daphnis.analysis.plot

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Plots of how the time of a computation falls with the number of threads. Needs no display. */
public object ScalingPlot {
    /**
     * Draws `NAME-time`, `NAME-speed` and `NAME-efficiency`, as SVG and PNG, into [directory], which is made.
     *
     * @param times for each engine, seconds against threads; an engine that was timed once is a point, and has no
     *   efficiency
     * @param yardstick what all are compared with; a dashed line. On one thread, n threads are n times as fast at best,
     *   which is drawn too
     * @param title what stands above
     * @throws IllegalArgumentException when there is no curve, or a time is not positive
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(times: List<Curve>, yardstick: Yardstick, directory: Path, name: String, title: String) {
        require(times.isNotEmpty()) { "there is nothing to draw" }
        val unit = yardstick.seconds
        require(times.all { c -> c.y.all { it > 0 } } && unit > 0) { "a time is not positive" }
        // Those of one point come last, so that each engine looks the same in all three.
        val pictures = PictureFiles(directory)
        val curves = times.sortedBy { it.x.size == 1 }
        val threads = times.flatMap { it.x.asList() }.map { it.toInt() }.distinct().sorted()
        fun draw(kind: String, drawn: List<Curve>, label: String, dashed: String, horizontal: Double) {
            val words = "grey dashes: $dashed"
            val plot =
                Chart.lines(drawn, "threads", label, title, horizontal = horizontal, ticks = threads, subtitle = words)
            pictures.write(plot, "$name-$kind")
        }
        draw("time", curves, "time [s]", "$yardstick", unit)
        val speeds = curves.map { c -> mapped(c) { _, t -> unit / t } }
        // Two threads may be more than twice as fast as two others; only one thread sets a bound.
        val bound = if (yardstick.threads == 1) listOf(ideal(times)) else emptyList()
        val label = "speed relative to $yardstick"
        val lines = if (label.length > LONGEST_LABEL) label.replace(" to ", " to\n") else label
        draw("speed", speeds + bound, lines, "$yardstick", 1.0)
        val measured = curves.filter { it.x.size > 1 && 1.0 in it.x.asList() }
        if (measured.isEmpty()) return
        val efficiencies = measured.map { c ->
            val one = c.y[c.x.indexOfFirst { it == 1.0 }]
            mapped(c) { n, t -> one / t / n }
        }
        draw("efficiency", efficiencies, "efficiency", "n threads n times as fast as one", 1.0)
    }

    /** Removes what [write] has drawn as [name] in [directory], if anything. */
    @JvmStatic
    @Throws(IOException::class)
    public fun remove(directory: Path, name: String) {
        for (kind in listOf("time", "speed", "efficiency")) {
            for (type in listOf("svg", "png")) Files.deleteIfExists(directory.resolve("$name-$kind.$type"))
        }
    }

    private fun mapped(curve: Curve, value: (x: Double, y: Double) -> Double) =
        Curve(curve.name, curve.x, DoubleArray(curve.x.size) { value(curve.x[it], curve.y[it]) })

    private fun ideal(times: List<Curve>): Curve {
        val x = times.flatMap { it.x.asList() }.distinct().sorted().toDoubleArray()
        return Curve("ideal", x, x)
    }

    private const val LONGEST_LABEL = 32
}
