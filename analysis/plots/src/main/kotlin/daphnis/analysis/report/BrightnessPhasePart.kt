package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table

/** I/F over phase angles along one line of sight, beside that of a sphere alone. */
internal class BrightnessPhasePart(private val study: Study, private val options: BrightnessOptions) : LightPart {
    private val elevation = study.options.elevation
    private val azimuth = study.options.azimuth
    private val phases = options.phases(elevation)
    private val lines = phases.map { options.line(elevation, azimuth, it) }
    private val measure = options.measure(lines)
    private val light = Averages(measure)
    private val place = "${ReportText.short(elevation)}° elevation and ${ReportText.short(azimuth)}° azimuth"

    override fun add(state: State) = light.add(state)

    /** I/F at each phase angle over that at the first. */
    private val ratios: List<BlockAverage> by lazy { phases.indices.map { ratio(it, 0) } }

    private fun ratio(of: Int, over: Int): BlockAverage {
        val columns = arrayOf(light.series(measure.total(of)), light.series(measure.total(over)))
        return BlockAverage.of(columns) { (a, b) -> if (b > 0) a / b else Double.NaN }
    }

    override fun rows(): List<NumberRow> {
        val rows = NumberRows()
        for (k in phases.indices.take(1)) {
            rows.average(null, "I/F at $place, ${at(k)}", light.average(measure.total(k)), "")
        }
        if (phases.size > 1) rows.average(null, "I/F at ${at(0)} over that at ${at(1)}", ratio(0, 1), "")
        return study.judgement.shown(rows.list())
    }

    private fun at(k: Int) = "phase angle ${ReportText.short(phases[k])}°"

    override fun write(page: ReportPage) {
        page.numbers(rows())
        val all = phases.indices.map { light.average(measure.total(it)) }
        val mean = DoubleArray(all.size) { all[it].mean }
        val errors = study.judgement.errors(DoubleArray(all.size) { all[it].error })
        val alone = options.law.ofSphere(Math.abs(lines[0].phaseAngle))
        val sphere = DoubleArray(phases.size) { mean[0] * options.law.ofSphere(Math.abs(lines[it].phaseAngle)) / alone }
        if (phases.size > 1) {
            val curves = listOf(Curve("patch", phases, mean, errors), Curve("sphere alone, scaled", phases, sphere))
            val caption =
                "I/F by phase angle at $place of the eye, beside the phase function of a sphere alone, which " +
                    "is scaled to the first. ${study.judgement.bars()}"
            val figure = Chart.lines(curves, "phase angle [degrees]", "I/F")
            study.draw(page, figure, "brightness-phase", "brightness by phase angle", caption)
        }
        Table(
            "brightness-phase",
            listOf(
                Column("phase_angle", "degrees", phases),
                Column(
                    "light_azimuth",
                    "degrees",
                    DoubleArray(phases.size) {
                        ObservedRows.degrees(lines[it].lightAzimuth)
                    },
                ),
                Column("i_over_f", "", mean),
                Column("i_over_f_error", "", errors),
                Column("over_first", "", DoubleArray(phases.size) { ratios[it].mean }),
                Column("over_first_error", "", DoubleArray(phases.size) { study.judgement.error(ratios[it]) }),
            ) + orders(),
        ).write(study.tables)
    }

    /** I/F by order of scattering, where there are several. */
    private fun orders(): List<Column> = (1..measure.orders).filter { measure.orders > 1 }.flatMap { order ->
        val own = phases.indices.map { light.average(measure.transmission(it) + order) }
        listOf(
            Column("order_$order", "", DoubleArray(own.size) { own[it].mean }),
            Column("order_${order}_error", "", DoubleArray(own.size) { study.judgement.error(own[it]) }),
        )
    }
}
