package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.Figures
import daphnis.analysis.profile.DispersionBySize
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import java.nio.file.Path
import kotlin.math.sqrt

/** The section on what particles of each size do, where there is more than one size. */
internal class SizeClassSection(private val input: AnalysisInput, private val classes: Int, private val averages: Averages) {
    private val units = input.units

    fun write(page: ReportPage, plots: Path, tables: Path) {
        val radius = DoubleArray(classes) { average(it, "mean_radius").mean }
        val filled = (0 until classes).filter { !radius[it].isNaN() && !average(it, "c2").mean.isNaN() }
        if (filled.isEmpty()) return
        page.section("Sizes")
        val names = listOf("c_xx" to "sigma_x", "c_yy" to "sigma_y", "c_zz" to "sigma_z", "c2" to "c")
        val columns = arrayListOf(column("count", "", filled) { average(it, "count").mean }, column("mean_radius", units.length, filled) { radius[it] })
        for ((square, name) in names) columns += roots(square, name, units.speed, filled)
        if (input.omega != null) columns += roots("h2", "H", units.length, filled)
        Table("size-classes", columns).write(tables)
        fun curve(label: String, name: String) = Curve(
            label,
            DoubleArray(filled.size) { radius[filled[it]] },
            columns.first { it.name == name }.values,
            columns.first { it.name == "${name}_error" }.values,
        )
        val dispersions = listOf(curve("σ_x", "sigma_x"), curve("σ_y", "sigma_y"), curve("σ_z", "sigma_z"))
        val caption = "of particles by size, around the mean flow and the centre of mass of all. Bars are one standard error."
        draw(page, plots, "size-dispersion", dispersions, "velocity dispersion [${units.speed}]", "Velocity dispersions $caption")
        if (input.omega != null) draw(page, plots, "size-height", listOf(curve("H", "H")), "scale height H [${units.length}]", "Scale heights $caption")
    }

    private fun draw(page: ReportPage, plots: Path, name: String, curves: List<Curve>, label: String, caption: String) {
        val figure = Chart.lines(curves, "radius [${units.length}]", label, logX = true)
        page.svg(Figures.write(figure, plots, name, Chart.WIDTH, Chart.HEIGHT), label.substringBefore(" [") + " by size", caption)
    }

    private fun average(c: Int, column: String): BlockAverage = averages.average(c * DispersionBySize.COLUMNS.size + DispersionBySize.COLUMNS.indexOf(column))

    private inline fun column(name: String, unit: String, filled: List<Int>, value: (Int) -> Double) = Column(name, unit, DoubleArray(filled.size) { value(filled[it]) })

    private fun roots(square: String, name: String, unit: String, filled: List<Int>): List<Column> = listOf(
        column(name, unit, filled) { sqrt(average(it, square).mean) },
        column("${name}_error", unit, filled) { c -> average(c, square).let { it.error / (2 * sqrt(it.mean)) } },
    )
}
