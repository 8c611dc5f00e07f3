package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.profile.DispersionBySize
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import kotlin.math.sqrt

/** What particles of each size do, where there is more than one size. */
internal class SizeClassSection(private val study: Study) : Section {
    private val units = study.units
    private val sizes = DispersionBySize.of(study.last)
    private val averages = sizes?.let { Averages(it) }
    private val classes = sizes?.classes ?: 0
    private val radius by lazy { DoubleArray(classes) { average(it, "mean_radius").mean } }
    private val filled by lazy { (0 until classes).filter { !radius[it].isNaN() && !average(it, "c2").mean.isNaN() } }

    override val heading = "Sizes"
    override val over get() =
        "Particles by size, around the mean flow and the centre of mass of all. ${study.overAverages} " +
            "By number. ${study.judgement.bars()}"
    override val applies = study.isRing || study.input.hasVelocities
    override val leftOut get() = when {
        averages == null && study.bulk.particles < study.last.population.size ->
            "all particles but bodies have one radius"
        averages == null -> "all particles have one radius"
        filled.isEmpty() -> "too few particles"
        else -> null
    }

    override fun add(state: State) {
        averages?.add(state)
    }

    override fun write(page: ReportPage) {
        val hasVelocities = study.input.hasVelocities
        val names = if (hasVelocities) SIGMAS + ("c2" to "c") else emptyList()
        val columns = arrayListOf(
            column("count", "", filled) { average(it, "count").mean },
            column("mean_radius", units.length, filled) { radius[it] },
        )
        for ((square, name) in names) columns += roots(square, name, units.speed, filled)
        if (study.isRing) columns += roots("h2", "H", units.length, filled)
        Table("size-classes", columns).write(study.tables)
        fun curve(label: String, name: String, one: Double) = Curve(
            label,
            DoubleArray(filled.size) { radius[filled[it]] },
            columns.first { it.name == name }.values.map { it / one }.toDoubleArray(),
            columns.first { it.name == "${name}_error" }.values.map { it / one }.toDoubleArray(),
        )
        val scale = study.scale
        if (hasVelocities) {
            val dispersions = listOf("σ_x" to "sigma_x", "σ_y" to "sigma_y", "σ_z" to "sigma_z")
                .map { (label, name) -> curve(label, name, scale.speed) }
            draw(page, "size-dispersion", dispersions, "velocity dispersion", scale.speedName)
        }
        if (study.isRing) draw(page, "size-height", listOf(curve("H", "H", 1.0)), "scale height H", units.length)
    }

    private fun draw(page: ReportPage, name: String, curves: List<Curve>, quantity: String, unit: String) {
        val figure = Chart.lines(curves, study.lengthAxis("radius"), UnitNames.axis(quantity, unit), logX = true)
        val said = quantity.replaceFirstChar { it.uppercase() }
        study.draw(page, figure, name, "$quantity by size", "$said of particles by size.")
    }

    private fun average(c: Int, column: String): BlockAverage = averages!!.average(
        c * DispersionBySize.COLUMNS.size + DispersionBySize.COLUMNS.indexOf(column),
    )

    private inline fun column(name: String, unit: String, filled: List<Int>, value: (Int) -> Double) = Column(
        name,
        unit,
        DoubleArray(filled.size) {
            value(filled[it])
        },
    )

    private fun roots(square: String, name: String, unit: String, filled: List<Int>): List<Column> = listOf(
        column(name, unit, filled) { sqrt(average(it, square).mean) },
        column("${name}_error", unit, filled) { c ->
            average(c, square).let {
                study.judgement.error(it) /
                    (2 * sqrt(it.mean))
            }
        },
    )

    private companion object {
        /** Columns of squares, and of their roots. */
        val SIGMAS = listOf("c_xx" to "sigma_x", "c_yy" to "sigma_y", "c_zz" to "sigma_z")
    }
}
