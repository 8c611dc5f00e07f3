package daphnis.analysis.report

import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.CurveChart
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import daphnis.analysis.transport.Transport
import daphnis.analysis.transport.TransportTable
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.run.TransportColumns
import kotlin.math.floor
import kotlin.math.sqrt

/**
 * A ring with self-gravity over time, from transport.csv: Toomre's Q beside 1, and the viscosity by orbit beside that
 * of wakes.
 *
 * @param mark where averages begin, in orbits, when that is within the run
 * @param across what every chart of the section shows
 */
internal class GravityEvolution(
    private val study: Study,
    private val transport: TransportTable,
    private val orbits: OrbitalFrequencies,
    private val mark: Double?,
    private val across: List<Double>,
) {
    private val scale = study.scale
    private val bulk = study.bulk
    private val time = DoubleArray(transport.size) { transport[TransportColumns.TIME][it] / scale.time }

    fun write(page: ReportPage, constant: Double) {
        toomre(page, 3.36 * constant * bulk.surfaceDensity / orbits.kappa)
        viscosity(page)
    }

    private fun toomre(page: ReportPage, marginal: Double) {
        val moment = transport[TransportColumns.moment("xx")]
        val q = DoubleArray(transport.size) { sqrt(moment[it]) / marginal }
        val caption =
            "Toomre's Q, of σ_x around the mean flow. Below the dashed line, Q = 1, an even sheet breaks up " +
                "radially (Toomre 1964)."
        study.draw(page, chart(time, q, "Q", "Toomre's Q", 1.0), "toomre-q", "Toomre's Q over time", caption)
        Table("toomre-q", listOf(Column("time", scale.timeName, time), Column("toomre_q", "", q))).write(study.tables)
    }

    /** Means over whole orbits: those of rows scatter by more than their mean. */
    private fun viscosity(page: ReportPage) {
        val flow = study.last.boundary.meanFlow ?: return
        val unit = bulk.meanRadius * bulk.meanRadius * orbits.omega
        val all = Transport(transport, flow.rate, flowAxis = flow.flowAxis).viscosities()
        val orbit = all.indices.groupBy { floor((time[it + 1] - time[0]) * (1 - ROUNDING)).toInt() }
        val whole = orbit.keys.filter { it < floor((time.last() - time[0]) * (1 + ROUNDING)) }
        if (whole.size < 2) return
        val middle = DoubleArray(whole.size) { time[0] + whole[it] + HALF }
        val mean = DoubleArray(whole.size) { k ->
            val rows = orbit.getValue(whole[k])
            rows.sumOf { all[it] * (time[it + 1] - time[it]) } / rows.sumOf { time[it + 1] - time[it] } / unit
        }
        val label = UnitNames.axis("kinematic viscosity", "r² Ω")
        val figure = chart(middle, mean, "viscosity, total", label, bulk.viscosityOfWakes / unit)
        val caption = "Total viscosity by orbit. The dashed line is that of wakes, 26 r_h⁵ G² Σ²/Ω³ (Daisaka, Tanaka " +
            "& Ida 2001), r_h = ${ReportText.short(bulk.hillRatio)}."
        study.draw(page, figure, "viscosity", "viscosity over time", caption)
        val columns = listOf(Column("time", scale.timeName, middle), Column("viscosity_total", "r² Ω", mean))
        Table("viscosity-by-orbit", columns).write(study.tables)
    }

    private fun chart(x: DoubleArray, y: DoubleArray, name: String, label: String, reference: Double): CurveChart {
        val stride = maxOf(1, x.size / MOST_POINTS)
        fun thinned(all: DoubleArray) = all.filterIndexed { k, _ -> k % stride == 0 }.toDoubleArray()
        val curve = Curve(name, thinned(x), thinned(y))
        val axis = UnitNames.axis("time", scale.timeName)
        return Chart.lines(listOf(curve), axis, label, horizontal = reference, vertical = mark, across = across)
    }

    private companion object {
        const val MOST_POINTS = 800
        const val HALF = 0.5

        /** A row at the end of an orbit may be off by this. */
        const val ROUNDING = 1e-9
    }
}
