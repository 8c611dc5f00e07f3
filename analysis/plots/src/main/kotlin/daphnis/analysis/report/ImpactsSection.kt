package daphnis.analysis.report

import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import kotlin.math.sqrt

/** How fast spheres meet: the distribution that the run wrote. */
internal class ImpactsSection(private val study: Study) : Section {
    private val impacts = study.input.impacts

    override val heading = "Impacts"
    override val over = "How fast ${study.bodies} meet. All collisions of the run."
    override val leftOut = when {
        study.input.directory == null -> "a file of states does not hold them"
        impacts == null -> "the run did not write them; it does with output.transportEvery"
        impacts.size < 2 -> "there are too few collisions"
        else -> null
    }

    override fun write(page: ReportPage) {
        val rows = impacts ?: return
        val unit = SpeedUnit(study.input.scenario, study.units.speed)
        val total = rows.collisions.sum()
        val x = DoubleArray(rows.size) { sqrt(rows.from[it] * rows.to[it]) * unit.factor }
        val y = DoubleArray(rows.size) { rows.collisions[it] / total / Math.log(rows.to[it] / rows.from[it]) }
        val curves = listOf(Curve("impacts", x, y))
        val figure = Chart.lines(
            curves,
            UnitNames.axis("impact speed", unit.name),
            "part of impacts per ln v",
            logX = true,
        )
        val caption = "Impact speeds of all collisions of the run."
        study.draw(page, figure, "impact-speeds", "distribution of impact speeds", caption)
        Table("impact-speeds", listOf(Column("speed", unit.name, x), Column("fraction_per_ln_v", "", y)))
            .write(study.tables)
    }
}
