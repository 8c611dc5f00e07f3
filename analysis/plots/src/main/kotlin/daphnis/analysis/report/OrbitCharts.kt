package daphnis.analysis.report

import daphnis.analysis.moonlet.BodyTable
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.UnitNames
import daphnis.core.run.BodyColumns
import kotlin.math.PI

/**
 * Orbits in `bodies.csv` over time.
 *
 * @param all their rows
 * @param what one of those that are on them is called
 */
internal class OrbitCharts(private val study: Study, private val all: List<BodyTable>, private val what: String) {
    private val orbit = study.input.omega?.let { 2 * PI / it } ?: 1.0

    fun write(page: ReportPage) {
        chart(page, "$what-walk", "change of the semi-major axis", "guiding centres of ${what}s over time") { body ->
            body[BodyColumns.GUIDING_X].let { x -> DoubleArray(x.size) { x[it] - x[0] } }
        }
        chart(page, "$what-eccentricity", "a·e", "eccentricity of ${what}s over time") {
            it[BodyColumns.ECCENTRICITY]
        }
    }

    private fun chart(page: ReportPage, name: String, of: String, alt: String, values: (BodyTable) -> DoubleArray) {
        val curves = all.take(MOST_CURVES).map { body ->
            val time = body[BodyColumns.TIME]
            Curve(name(body), DoubleArray(time.size) { time[it] / orbit }, values(body))
        }
        val label = UnitNames.axis(of, study.units.length)
        val figure = Chart.lines(curves, "time [orbits]", label, vertical = study.from / orbit)
        val left = if (all.size > MOST_CURVES) " The first $MOST_CURVES of ${all.size}." else ""
        val caption = "${capital(of)} of ${what}s over the whole run; dashed: where averages begin.$left"
        study.draw(page, figure, name, alt, caption)
    }

    private fun name(body: BodyTable) = if (body.id < 0) "$what ${-body.id}" else "body ${body.id}"

    /** A symbol stays as it is: a·e is not A·e. */
    private fun capital(of: String) = if (of[1].isLetter()) of.replaceFirstChar { it.uppercase() } else of

    private companion object {
        const val MOST_CURVES = 6
    }
}
