package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.SeriesPlots
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.core.run.SeriesColumns

/** A run whose spheres grow: no time of it is like another, so nothing is averaged over time. */
internal object Growth {
    /** Whether the scenario of [input] lets spheres grow or shrink. */
    fun isSeen(input: AnalysisInput): Boolean = input.scenario?.growth?.let { it.rate != 0.0 } == true

    /** That numbers are of the last state alone, and why. */
    fun remark(study: Study): String {
        val all = study.input.series?.takeIf { SeriesColumns.FILLING_FACTOR in it }?.get(SeriesColumns.FILLING_FACTOR)
        val path = all?.takeIf { it.size >= 2 }
            ?.let {
                " from the filling factor ${ReportText.short(
                    it.first(),
                )} to ${ReportText.short(study.bulk.fillingFactor)}"
            }
            .orEmpty()
        val change = if (study.input.scenario?.growth?.let { it.rate < 0 } == true) "shrink" else "grow"
        val what = "The ${study.bodies} $change$path, so averages over time mean nothing"
        return if (study.averaged.size == 1) "$what: numbers are of one state." else "$what."
    }

    /** Pressure over filling factor, beside that of the fluid of equal spheres; nothing where the series lacks it. */
    fun write(page: ReportPage, study: Study) {
        val series = study.input.series ?: return
        if (SeriesColumns.FILLING_FACTOR !in series || SeriesColumns.REDUCED_PRESSURE !in series) return
        val pressure = series[SeriesColumns.REDUCED_PRESSURE]
        val rows = pressure.indices.filter { pressure[it].isFinite() }
        if (rows.size < 2) return
        fun of(values: DoubleArray) = DoubleArray(rows.size) { values[rows[it]] }
        val filling = of(series[SeriesColumns.FILLING_FACTOR])
        val isPlane = study.last.boundary.space.isPlane
        val fluid = DoubleArray(rows.size) {
            if (isPlane) EquationOfState.ofDiscs(filling[it]) else EquationOfState.ofSpheres(filling[it])
        }
        val isEqual = ElasticGas.areEqual(study.last.population.radius)
        val source = if (isPlane) EquationOfState.HENDERSON else EquationOfState.CARNAHAN
        val curves = listOfNotNull(
            Curve("run", filling, of(pressure)),
            if (isEqual) Curve("fluid, $source", filling, fluid) else null,
        )
        val figure = Chart.lines(
            curves,
            if (isPlane) "area fraction" else "filling factor",
            "reduced pressure Z",
            logY = Chart.isWide(curves.flatMap { it.y.asList() }),
        )
        study.draw(
            page,
            figure,
            "compression",
            "reduced pressure over filling factor",
            "Reduced pressure Z = P ${if (isPlane) "A" else "V"}/(N kT), each of one step.",
            SeriesPlots.HEIGHT,
        )
        val times = DoubleArray(rows.size) { series[SeriesColumns.TIME][rows[it]] / study.scale.time }
        val columns = listOf(
            Column("time", study.scale.timeName, times),
            Column("filling_factor", "", filling),
            Column("reduced_pressure", "", of(pressure)),
        )
        Table("compression", columns + if (isEqual) listOf(Column("fluid", "", fluid)) else emptyList())
            .write(study.tables)
    }
}
