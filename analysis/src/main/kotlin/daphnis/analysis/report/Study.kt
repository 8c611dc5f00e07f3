package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Figures
import daphnis.analysis.plot.PlotScale
import daphnis.analysis.table.UnitNames
import org.jetbrains.letsPlot.Figure
import java.nio.file.Path
import kotlin.math.PI

/**
 * What the sections of a report are made from.
 *
 * @property last the last state
 * @property from averages begin at this time
 * @property averaged times of the states that are averaged, ascending; never empty
 */
internal class Study(
    val input: AnalysisInput,
    val measures: ReportAverages,
    val numbers: Numbers,
    val last: State,
    val from: Double,
    private val averaged: DoubleArray,
    val options: AnalysisOptions,
    directory: Path,
) {
    val plots: Path = directory.resolve("plots")
    val tables: Path = directory.resolve("tables")
    val units: UnitNames = input.units
    val scale: PlotScale = PlotScale(units, input.omega, numbers.meanRadius)
    val isRing: Boolean = input.omega != null

    /** Spheres that are no bodies. */
    val particles: Int = (0 until last.population.size).count { last.isParticle(it) }

    /** Which states an average is over: `5 states of 12, time 3.75 to 10 s (1.2 to 3.1 orbits)`. */
    val averagedStates: String = run {
        val all = if (averaged.size < input.size) " of ${input.size}" else ""
        "${ReportText.count(averaged.size, "state")}$all, time ${span(averaged.first(), averaged.last())}"
    }

    val overAverages: String = "Averages over $averagedStates."
    val overLast: String = "The last state, time ${time(last.time)}."

    /** [time] with its unit, in Hill's frame also in orbits. */
    fun time(time: Double): String = span(time, time)

    private fun span(begin: Double, end: Double): String {
        fun text(factor: Double): String {
            val first = ReportText.short(begin * factor)
            return if (begin == end) first else "$first to ${ReportText.short(end * factor)}"
        }
        val inUnits = UnitNames.amount(text(1.0), units.time)
        val omega = input.omega ?: return inUnits
        val orbits = text(omega / (2 * PI))
        return "$inUnits ($orbits ${if (orbits == "1") "orbit" else "orbits"})"
    }

    /** Why nothing is said of fewer than [least] particles; null when there are enough. */
    fun tooFew(least: Int): String? {
        if (particles >= least) return null
        val there = if (particles == 1) "there is" else "there are"
        return "$there ${ReportText.count(particles, "particle")}; it takes $least at least"
    }

    /** A quantity with the unit of length at an axis. */
    fun lengthAxis(quantity: String): String = UnitNames.axis(quantity, units.length)

    /** Draws [figure] into `plots/NAME.svg` and `.png` and onto [page]. */
    fun draw(page: ReportPage, figure: Figure, name: String, alt: String, caption: String, height: Int = Chart.HEIGHT) {
        page.svg(Figures.write(figure, plots, name, Chart.WIDTH, height), alt, caption)
    }
}

/**
 * A section of the report: its text, its table, its figures. To add one, write it in a file of its own and name it in
 * [Sections].
 */
internal interface Section {
    val heading: String

    /** What it shows and over which states: the first line under the heading. */
    val over: String

    /** Why it would mean nothing here, as the end of a sentence; null when it means something. */
    val leftOut: String? get() = null

    /** Writes what follows the heading and [over]. */
    fun write(page: ReportPage)
}

/** A section from its parts. */
internal class PlainSection(
    override val heading: String,
    override val over: String,
    override val leftOut: String? = null,
    private val body: (ReportPage) -> Unit,
) : Section {
    override fun write(page: ReportPage) = body(page)
}
