package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.SeriesPlots
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.core.format.Snapshot
import daphnis.core.run.SeriesColumns
import kotlin.math.abs

/** A run whose spheres grow: no time of it is like another, so nothing is averaged over time. */
internal object Growth {
    /** Whether the scenario of [input] lets spheres grow or shrink, or most of a file have other radii in the end. */
    fun isSeen(input: AnalysisInput): Boolean {
        input.scenario?.growth?.let { if (it.rate != 0.0) return true }
        if (input.directory != null && input.scenario != null || input.size < 2) return false
        val first = input.snapshot(0)
        val last = input.snapshot(input.size - 1)
        val before = ranked(first)
        val after = ranked(last)
        val others = after.count { (name, radius) -> before[name]?.let { abs(radius - it) > SAME * it } == true }
        return 2 * others > last.size
    }

    /** Radii by id; where rows of a file may be in any order, by their rank. */
    private fun ranked(state: Snapshot): Map<Int, Double> = if (state.hasId) {
        state.id.zip(state.radius.asList()).toMap()
    } else {
        state.radius.sorted().withIndex().associate { it.index to it.value }
    }

    /** That numbers are of the last state alone, and why. */
    fun remark(study: Study): String {
        val all = study.input.series?.takeIf { SeriesColumns.FILLING_FACTOR in it }?.get(SeriesColumns.FILLING_FACTOR)
        val first = if (study.input.series != null) {
            all?.takeIf { it.size >= 2 }?.first()
        } else {
            Bulk(study.input.state(0), study.input).fillingFactor
        }
        val path = first?.takeIf { it.isFinite() }?.let {
            " from the filling factor ${ReportText.short(it)} to ${ReportText.short(study.bulk.fillingFactor)}"
        }.orEmpty()
        val rate = study.input.scenario?.growth?.rate ?: 0.0
        val change = if (rate < 0) {
            "shrink"
        } else if (rate > 0) {
            "grow"
        } else {
            "change their radii"
        }
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

    /** Rounding of radii in files, relative to them. */
    private const val SAME = 1e-6
}
