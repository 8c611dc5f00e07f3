package daphnis.analysis.report

import daphnis.analysis.correlation.SurfaceMap
import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.Figures
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.sqrt

/** The sections on how particles stand and meet: correlations, occultation, impacts. */
internal class StructureSections(
    private val input: AnalysisInput,
    private val measures: Measures,
    private val numbers: Numbers,
    private val plots: Path,
    private val tables: Path,
) {
    private val units = input.units

    fun correlations(page: ReportPage) {
        spectrum(
            page,
            "pair-correlation",
            DoubleArray(measures.pairs.bins) { measures.pairs.centre(it) },
            measures.ofPairs,
            units.length,
            "distance",
            "g",
            if (input.omega !=
                null
            ) {
                "Pair correlation in the plane: pairs at a distance seen from above, over those of particles without correlation."
            } else {
                "Radial distribution function."
            },
        )
        spectrum(
            page,
            "structure-factor",
            DoubleArray(measures.structure.bins) {
                measures.structure.centre(it)
            },
            measures.ofStructure,
            units.waveNumber,
            "wave number |k|",
            "S",
            "Structure factor S(k) of wave vectors in the plane, averaged over directions; 1 for particles without correlation.",
        )
        val a = measures.autocorrelation
        if (a.isEmpty() || measures.lagX < 2 || measures.lagY < 2) return
        val x = DoubleArray(2 * measures.lagX + 1) { (it - measures.lagX) * measures.dx }
        val y = DoubleArray(2 * measures.lagY + 1) { (it - measures.lagY) * measures.dy }
        // The centre is the noise of counting and would hide the rest.
        val shown = a.copyOf().also { it[measures.lagX * y.size + measures.lagY] = 0.0 }
        val pitch = Math.toDegrees(SurfaceMap.pitchAngle(a, measures.lagX, measures.lagY, measures.dx, measures.dy))
        val lean = if (input.omega !=
            null
        ) {
            " Pitch angle of the central ridge, counted from the orbit, trailing positive: ${ReportText.short(pitch)}°; without wakes it means nothing."
        } else {
            ""
        }
        page.svg(
            Figures.write(Chart.map(x, y, shown, "Δy [${units.length}]", "Δx [${units.length}]", "A"), plots, "autocorrelation", Chart.WIDTH, MAP_HEIGHT),
            "autocorrelation of the surface density",
            "Autocorrelation of the surface density, ⟨δΣ δΣ⟩/⟨Σ⟩², the centre left out.$lean",
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

    private fun spectrum(page: ReportPage, name: String, x: DoubleArray, averages: Averages, unit: String, xLabel: String, yLabel: String, caption: String) {
        val all = x.indices.map { averages.average(it) }
        val y = DoubleArray(x.size) { all[it].mean }
        val error = DoubleArray(x.size) { all[it].error }
        val figure = Chart.lines(listOf(Curve(yLabel, x, y, error)), "$xLabel [$unit]", yLabel, horizontal = 1.0)
        page.svg(Figures.write(figure, plots, name, Chart.WIDTH, Chart.HEIGHT), caption, "$caption Bars are one standard error.")
        Table(name, listOf(Column(if (unit.startsWith("1/")) "k" else "r", unit, x), Column(yLabel, "", y), Column("${yLabel}_error", "", error))).write(tables)
    }

    fun occultation(page: ReportPage) {
        val b = measures.elevation
        val transmission = measures.ofDepth.average(0)
        val depth = measures.ofDepth.average(1)
        page.numbers(
            listOf(
                NumberRow("rays that come through at ${ReportText.short(b)}° elevation", transmission.mean, transmission.error, ""),
                NumberRow("normal optical depth −sin B · ln T", depth.mean, depth.error, ""),
                NumberRow("geometric optical depth", numbers.opticalDepth, Double.NaN, ""),
            ),
        )
        val n = measures.ofScan.width
        val box = input.state(input.size - 1).boundary.box
        val x = DoubleArray(n) { box.lowerX + (it + 0.5) * box.length(0) / n }
        val scan = measures.ofScan.let { s -> DoubleArray(n) { s.series(it).last() } }
        val mean = DoubleArray(n) { measures.ofScan.average(it).mean }
        val figure = Chart.lines(
            listOf(Curve("last state", x, scan), Curve("mean", x, mean)),
            if (input.omega !=
                null
            ) {
                "radial position x [${units.length}]"
            } else {
                "x [${units.length}]"
            },
            "transmission",
        )
        page.svg(
            Figures.write(figure, plots, "occultation", Chart.WIDTH, Chart.HEIGHT),
            "synthetic occultation",
            "Synthetic occultation: part of the light that comes through along the orbit at each radius, from rays through the particles and their images.",
        )
        Table("occultation", listOf(Column("x", units.length, x), Column("transmission_last", "", scan), Column("transmission_mean", "", mean))).write(tables)
    }

    fun impacts(page: ReportPage) {
        val file = input.directory?.impacts ?: return
        if (!Files.exists(file)) return
        val rows = Files.readAllLines(file).drop(1).map { line -> line.split(',').map { it.toDouble() } }
        if (rows.size < 2) return
        val factor = input.scenario?.units?.speedInCmPerSecond ?: 1.0
        val total = rows.sumOf { it[2] }
        val x = DoubleArray(rows.size) { sqrt(rows[it][0] * rows[it][1]) * factor }
        val y = DoubleArray(rows.size) { rows[it][2] / total / Math.log(rows[it][1] / rows[it][0]) }
        val figure = Chart.lines(listOf(Curve("impacts", x, y)), "impact speed [cm/s]", "part of impacts per ln v", logX = true)
        page.svg(Figures.write(figure, plots, "impact-speeds", Chart.WIDTH, Chart.HEIGHT), "distribution of impact speeds", "Impact speeds of all collisions of the run.")
        Table("impact-speeds", listOf(Column("speed", "cm/s", x), Column("fraction_per_ln_v", "", y))).write(tables)
    }

    private companion object {
        const val MAP_HEIGHT = 560
    }
}
