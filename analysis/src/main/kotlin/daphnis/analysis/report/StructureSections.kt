package daphnis.analysis.report

import daphnis.analysis.correlation.PairCorrelation
import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.Figures
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import java.nio.file.Path
import kotlin.math.sqrt

/** The sections on how particles stand and meet: correlations, occultation, impacts. */
internal class StructureSections(
    private val input: AnalysisInput,
    private val measures: ReportAverages,
    private val numbers: Numbers,
    private val plots: Path,
    private val tables: Path,
) {
    private val units = input.units

    fun correlations(page: ReportPage) {
        pairCorrelation(page)
        spectrum(
            page,
            "structure-factor",
            DoubleArray(measures.structure.bins) { measures.structure.centre(it) },
            measures.ofStructure,
            Quantity("structure factor", "S", "wave number |k|", units.waveNumber),
            "Structure factor S(k) of wave vectors in the plane, averaged over directions; 1 for particles without correlation.",
        )
        val a = measures.meanAutocorrelation()
        if (a.isEmpty() || measures.lagX < 2 || measures.lagY < 2) return
        autocorrelation(page, a)
        if (input.omega != null) WakeSection(input, measures, numbers, tables).write(page)
    }

    private fun pairCorrelation(page: ReportPage) {
        val pairs = measures.pairs
        val inPlane = PairCorrelation.isInPlane(input.state(input.size - 1).boundary)
        val caption = if (inPlane) {
            "Pair correlation in the x-y plane: pairs at a distance seen along z, over those of particles without correlation. Spheres one above the other are nearer " +
                "than contact in this view, so that g is not 0 there."
        } else {
            val from = if (pairs.nearest > 0) {
                " Bins begin at the contact of the smallest spheres, ${UnitNames.amount(
                    ReportText.short(pairs.nearest),
                    units.length,
                )}."
            } else {
                ""
            }
            "Radial distribution function in space: pairs at a distance, over those of particles without correlation.$from"
        }
        spectrum(
            page,
            "pair-correlation",
            DoubleArray(pairs.bins) { pairs.centre(it) },
            measures.ofPairs,
            Quantity("pair correlation", "g", if (inPlane) "distance in the plane" else "distance r", units.length),
            caption,
        )
    }

    private fun autocorrelation(page: ReportPage, a: DoubleArray) {
        val x = DoubleArray(2 * measures.lagX + 1) { (it - measures.lagX) * measures.dx }
        val y = DoubleArray(2 * measures.lagY + 1) { (it - measures.lagY) * measures.dy }
        // The centre is the noise of counting and would hide the rest.
        val shown = a.copyOf().also { it[measures.lagX * y.size + measures.lagY] = 0.0 }
        val figure = Chart.map(
            x,
            y,
            shown,
            UnitNames.axis("Δy", units.length),
            UnitNames.axis("Δx", units.length),
            "autocorrelation A",
        )
        page.svg(
            Figures.write(figure, plots, "autocorrelation", Chart.WIDTH, MAP_HEIGHT),
            "autocorrelation of the surface density",
            "Autocorrelation A of the surface density, ⟨δΣ δΣ⟩/⟨Σ⟩², the centre left out.",
        )
        Table(
            "autocorrelation",
            listOf(
                Column("dx", units.length, DoubleArray(a.size) { x[it / y.size] }),
                Column("dy", units.length, DoubleArray(a.size) { y[it % y.size] }),
                Column("A", "", a),
            ),
        ).write(tables)
    }

    /** What is drawn over what: its [words] and [symbol], and the [argument] with its [unit]. */
    private class Quantity(val words: String, val symbol: String, val argument: String, val unit: String)

    private fun spectrum(
        page: ReportPage,
        name: String,
        x: DoubleArray,
        averages: Averages,
        quantity: Quantity,
        caption: String,
    ) {
        val all = x.indices.map { averages.average(it) }
        val y = DoubleArray(x.size) { all[it].mean }
        val error = DoubleArray(x.size) { all[it].error }
        val label = "${quantity.words} ${quantity.symbol}"
        val figure = Chart.lines(
            listOf(Curve(label, x, y, error)),
            UnitNames.axis(quantity.argument, quantity.unit),
            label,
            horizontal = 1.0,
        )
        page.svg(
            Figures.write(figure, plots, name, Chart.WIDTH, Chart.HEIGHT),
            quantity.words,
            "$caption Bars are one standard error, from 16 states on.",
        )
        val argument = if (quantity.unit.startsWith("1/")) "k" else "r"
        Table(
            name,
            listOf(
                Column(argument, quantity.unit, x),
                Column(quantity.symbol, "", y),
                Column("${quantity.symbol}_error", "", error),
            ),
        ).write(tables)
    }

    fun occultation(page: ReportPage) {
        val light = measures.ofLight
        val transmission = light.average(0)
        val rays = "${ReportText.short(
            measures.options.elevation,
        )}° elevation and ${ReportText.short(measures.options.azimuth)}° azimuth"
        page.numbers(
            listOf(
                NumberRow("rays that come through at $rays", transmission.mean, transmission.error, ""),
                depthRow(transmission),
                NumberRow("geometric optical depth", numbers.opticalDepth, Double.NaN, ""),
            ),
        )
        val n = light.width - 1
        val box = input.state(input.size - 1).boundary.box
        val x = DoubleArray(n) { box.lowerX + (it + 0.5) * box.length(0) / n }
        val scan = DoubleArray(n) { light.series(1 + it).last() }
        val mean = DoubleArray(n) { light.average(1 + it).mean }
        val label = UnitNames.axis(if (input.omega != null) "radial position x" else "x", units.length)
        val figure = Chart.lines(listOf(Curve("last state", x, scan), Curve("mean", x, mean)), label, "transmission")
        page.svg(
            Figures.write(figure, plots, "occultation", Chart.WIDTH, Chart.HEIGHT),
            "synthetic occultation",
            "Synthetic occultation: share of the light that comes through along y at each x, from rays through the particles and their images at $rays, which is the " +
                "direction in the plane in which they climb, from x toward y.",
        )
        Table(
            "occultation",
            listOf(
                Column("x", units.length, x),
                Column("transmission_last", "", scan),
                Column("transmission_mean", "", mean),
            ),
        ).write(tables)
    }

    private fun depthRow(transmission: BlockAverage): NumberRow {
        val what = "normal optical depth −sin B · ln T"
        if (transmission.mean <= 0) {
            return NumberRow(what, Double.NaN, Double.NaN, "", note = "opaque: no ray comes through")
        }
        val depth = measures.rays.depth(transmission)
        return NumberRow(what, depth.mean, depth.error, "", note = "T averaged over the states first")
    }

    fun impacts(page: ReportPage) {
        val rows = input.impacts ?: return
        if (rows.size < 2) return
        val factor = input.scenario?.units?.speedInCmPerSecond ?: 1.0
        val total = rows.collisions.sum()
        val x = DoubleArray(rows.size) { sqrt(rows.from[it] * rows.to[it]) * factor }
        val y = DoubleArray(rows.size) { rows.collisions[it] / total / Math.log(rows.to[it] / rows.from[it]) }
        val figure = Chart.lines(
            listOf(Curve("impacts", x, y)),
            "impact speed [cm/s]",
            "part of impacts per ln v",
            logX = true,
        )
        page.svg(
            Figures.write(figure, plots, "impact-speeds", Chart.WIDTH, Chart.HEIGHT),
            "distribution of impact speeds",
            "Impact speeds of all collisions of the run.",
        )
        Table("impact-speeds", listOf(Column("speed", "cm/s", x), Column("fraction_per_ln_v", "", y))).write(tables)
    }

    private companion object {
        const val MAP_HEIGHT = 560
    }
}
