package daphnis.analysis.report

import daphnis.analysis.brightness.BrightnessComparison
import daphnis.analysis.brightness.ObservedBrightness
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table

/** The brightness of the patch beside what was [observed] under the same light. */
internal class ObservedBrightnessPart(
    private val study: Study,
    options: BrightnessOptions,
    private val observed: ObservedBrightness,
) : LightPart {
    private val measure = options.measure(observed.lines)
    private val light = Averages(measure)
    private val n = observed.lines.size

    override fun add(state: State) = light.add(state)

    private val comparison by lazy { BrightnessComparison(observed, List(n) { light.average(measure.total(it)) }) }

    override fun rows(): List<NumberRow> {
        val rows = NumberRows()
        fun expected(count: Int) = "$count expected, ± ${ReportText.short(Math.sqrt(2.0 * count))}"
        rows.exact(null, "χ² against the observed I/F", comparison.chiSquare, "", expected(n))
        if (comparison.factor.isNaN()) return rows.list()
        val (factor, error) = comparison.factor to comparison.factorError
        rows.change(
            null,
            "observed I/F over that of the patch, best factor",
            factor,
            error,
            "",
            "errors as independent",
        )
        if (n > 1) rows.exact(null, "χ² with this factor", comparison.chiSquareOfFactor, "", expected(n - 1))
        return rows.list()
    }

    override fun write(page: ReportPage) {
        page.numbers(rows())
        val index = DoubleArray(n) { (it + 1).toDouble() }
        val mean = DoubleArray(n) { comparison.seen[it].mean }
        val errors = study.judgement.errors(DoubleArray(n) { comparison.seen[it].error })
        val figure = Chart.lines(
            listOf(Curve("observed", index, observed.values, observed.errors), Curve("patch", index, mean, errors)),
            "elevation, azimuth, phase angle of the row [degrees]",
            "I/F",
            marks = ObservedRows.marks(observed.lines.map { listOf(it.eye.elevation, it.eye.azimuth, it.phaseAngle) }),
            joined = false,
        )
        val caption =
            "I/F of the patch under the light and along the lines of sight of the observed one, row by row. χ² " +
                "has both errors; lines through the same states are not quite independent. ${study.judgement.bars()}"
        study.draw(page, figure, "brightness-observed", "brightness, observed and of the patch", caption)
        fun angle(name: String, of: (Int) -> Double) =
            Column(name, "degrees", DoubleArray(n) { ObservedRows.degrees(of(it)) })
        Table(
            "brightness-observed",
            listOf(
                angle("elevation") { observed.lines[it].eye.elevation },
                angle("azimuth") { observed.lines[it].eye.azimuth },
                angle("light_elevation") { observed.lines[it].lightElevation },
                angle("phase_angle") { observed.lines[it].phaseAngle },
                Column("observed", "", observed.values),
                Column("observed_error", "", observed.errors),
                Column("patch", "", mean),
                Column("patch_error", "", errors),
                Column("residual", "", comparison.residuals),
                Column("residual_over_error", "", DoubleArray(n) { comparison.residuals[it] / comparison.errors[it] }),
            ),
        ).write(study.tables)
    }
}
