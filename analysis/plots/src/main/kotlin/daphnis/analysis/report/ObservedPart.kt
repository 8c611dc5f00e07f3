package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.occultation.DepthComparison
import daphnis.analysis.occultation.ObservedDepths
import daphnis.analysis.occultation.Transmissions
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table

/** The light through the patch beside what was [observed] along the same lines of sight. */
internal class ObservedPart(private val study: Study, private val observed: ObservedDepths) : LightPart {
    private val light = Averages(Transmissions(observed.lines))

    override fun add(state: State) = light.add(state)

    private val what = if (observed.areDepths) "normal optical depth" else "transmission"
    private val comparison by lazy { DepthComparison(observed, List(light.width) { light.average(it) }) }

    override fun rows(): List<NumberRow> {
        val rows = NumberRows()
        val count = comparison.count
        if (count > 0) {
            val expected = "$count expected, ± ${ReportText.short(Math.sqrt(2.0 * count))}"
            rows.exact(null, "χ² against the observed ${what}s", comparison.chiSquare, "", expected)
        }
        val opaque = observed.lines.size - count
        if (opaque > 0) {
            val note = if (count > 0) "" else "there is nothing to compare"
            rows.exact(null, "lines along which nothing comes through, left out", opaque.toDouble(), "", note)
        }
        return rows.list()
    }

    override fun write(page: ReportPage) {
        page.numbers(rows())
        val remarks = observed.remarks
        if (remarks.isNotEmpty()) {
            val more = remarks.size - MOST_REMARKS
            page.paragraph(remarks.take(MOST_REMARKS).joinToString(" ") + if (more > 0) " So have $more more." else "")
        }
        val n = observed.lines.size
        val seen = DoubleArray(n) { comparison.seen[it].mean }
        val seenErrors = study.judgement.errors(DoubleArray(n) { comparison.seen[it].error })
        val elevations = DoubleArray(n) { ObservedRows.degrees(observed.lines[it].elevation) }
        val index = DoubleArray(n) { (it + 1).toDouble() }
        val figure = Chart.lines(
            listOf(Curve("observed", index, observed.values, observed.errors), Curve("patch", index, seen, seenErrors)),
            "elevation and azimuth of the row [degrees]",
            what,
            marks = ObservedRows.marks(observed.lines.map { listOf(it.elevation, it.azimuth) }),
            joined = false,
        )
        val caption =
            "The ${what}s of the patch along the lines of sight of the observed ones, row by row. χ² has both " +
                "errors; lines through the same states are not quite independent. ${study.judgement.bars()}"
        study.draw(page, figure, "occultation-observed", "$what, observed and of the patch", caption)
        Table(
            "occultation-observed",
            listOf(
                Column("elevation", "degrees", elevations),
                Column("azimuth", "degrees", DoubleArray(n) { ObservedRows.degrees(observed.lines[it].azimuth) }),
                Column("observed", "", observed.values),
                Column("observed_error", "", observed.errors),
                Column("patch", "", DoubleArray(n) { if (seen[it].isFinite()) seen[it] else Double.NaN }),
                Column("patch_error", "", seenErrors),
                Column("residual", "", comparison.residuals),
                Column("residual_over_error", "", DoubleArray(n) { comparison.residuals[it] / comparison.errors[it] }),
            ),
        ).write(study.tables)
    }

    private companion object {
        const val MOST_REMARKS = 5
    }
}
