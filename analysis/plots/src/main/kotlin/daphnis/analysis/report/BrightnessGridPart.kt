package daphnis.analysis.report

import daphnis.analysis.brightness.AzimuthalAsymmetry
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.NamedMarks
import daphnis.analysis.plot.Ticks
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import kotlin.math.PI

/** I/F over a grid of elevations and azimuths, and how it depends on both: the tilt effect and the asymmetry. */
internal class BrightnessGridPart(private val study: Study, private val options: BrightnessOptions) : LightPart {
    private val elevations = options.elevations(study.options)
    private val azimuths = options.azimuths(study.options)
    private val n = azimuths.size
    private val lines = elevations.flatMap { b -> azimuths.map { options.line(b, it, options.phase(b)) } }
    private val measure = options.measure(lines)
    private val light = Averages(measure)

    override fun add(state: State) = light.add(state)

    /** Over all azimuths, by elevation. */
    private val means: List<BlockAverage> by lazy { elevations.indices.map { mean(it, measure::total) } }

    private val single: List<BlockAverage> by lazy {
        elevations.indices.map { mean(it) { k -> measure.transmission(k) + 1 } }
    }

    private val asymmetries: List<AzimuthalAsymmetry?> by lazy {
        elevations.indices.map { i -> AzimuthalAsymmetry.of(Array(n) { light.series(measure.total(i * n + it)) }) }
    }

    private fun mean(elevation: Int, number: (line: Int) -> Int): BlockAverage {
        val series = Array(n) { light.series(number(elevation * n + it)) }
        return BlockAverage.of(DoubleArray(series[0].size) { k -> series.sumOf { it[k] } / n })
    }

    override fun rows(): List<NumberRow> {
        val rows = NumberRows()
        for (i in elevations.indices.take(MOST_ROWS)) {
            val place = "at ${ReportText.short(elevations[i])}°"
            val note = "phase angle ${ReportText.short(options.phase(elevations[i]))}°"
            rows.average(null, "I/F over all azimuths $place", means[i], "", note)
            if (options.orders > 1) rows.average(null, "I/F of single scattering $place", single[i], "")
            val asymmetry = asymmetries[i] ?: continue
            rows.average(null, "azimuthal asymmetry $place", asymmetry.amplitude, "", "(largest − smallest)/mean")
            if (!isSeen(asymmetry)) continue
            val before = asymmetry.minimum * (HALF / PI)
            rows.average(null, "darkest before the ansae $place", before, "degrees", "in the direction of motion")
        }
        return study.judgement.shown(rows.list())
    }

    /** Whether there is a darkest place: ansae are those of a ring, and without errors nobody knows what chance makes. */
    private fun isSeen(asymmetry: AzimuthalAsymmetry) =
        study.isRing && asymmetry.isSeen && !study.judgement.error(asymmetry.minimum).isNaN()

    override fun write(page: ReportPage) {
        page.numbers(rows())
        if (study.isRing && asymmetries.none { it != null && isSeen(it) }) {
            page.paragraph(
                "There is no darkest azimuth: I/F does not depend on the azimuth by more than chance makes it, or " +
                    "there are no errors that could tell (too few states, or a run that is not steady), or fewer " +
                    "than three azimuths in half a turn.",
            )
        }
        azimuths(page)
        if (elevations.size > 1) tilt(page)
        grid()
        Table("brightness-elevation", byElevation()).write(study.tables)
    }

    private fun azimuths(page: ReportPage) {
        val curves = elevations.mapIndexed { i, elevation ->
            val own = List(n) { light.average(measure.total(i * n + it)) }
            // The turn ends where it began.
            Curve(
                "B = ${ReportText.short(elevation)}°",
                azimuths + (azimuths[0] + 2 * HALF),
                DoubleArray(n + 1) { own[it % n].mean },
                study.judgement.errors(DoubleArray(n + 1) { own[it % n].error }),
            )
        }
        val figure = Chart.lines(curves, "azimuth A [degrees]", "I/F", marks = TURN)
        val ansae = if (study.isRing) ANSAE else ""
        val caption = "I/F by the azimuth A at which the eye stands, from x toward y, at each of its elevations B. " +
            "${lit()}$ansae ${study.judgement.bars()}"
        study.draw(page, figure, "brightness-azimuth", "brightness by azimuth and elevation", caption)
    }

    private fun tilt(page: ReportPage) {
        val curve = Curve(
            "I/F",
            elevations,
            DoubleArray(elevations.size) { means[it].mean },
            study.judgement.errors(DoubleArray(elevations.size) { means[it].error }),
        )
        val figure = Chart.lines(listOf(curve), "elevation B [degrees]", "I/F")
        val caption = "I/F over all azimuths by the elevation of the eye. ${lit()} ${study.judgement.bars()}"
        study.draw(page, figure, "brightness-elevation", "brightness by elevation", caption)
    }

    private fun lit(): String {
        val light = options.lightElevation?.let { "The light stands at ${ReportText.short(it)}°" }
            ?: "The light stands as high as the eye"
        val angle = options.phaseAngle ?: 0.0.takeIf { options.lightElevation == null }
        val phase = angle?.let { "${ReportText.short(it)}°" } ?: "the least"
        return "$light, the phase angle is $phase."
    }

    private fun grid() {
        fun of(number: (Int) -> Double) = DoubleArray(lines.size) { number(it) }
        fun both(name: String, number: (Int) -> Int) = listOf(
            Column(name, "", of { light.average(number(it)).mean }),
            Column("${name}_error", "", of { study.judgement.error(light.average(number(it))) }),
        )
        Table(
            "brightness-grid",
            listOf(
                Column("elevation", "degrees", of { elevations[it / n] }),
                Column("azimuth", "degrees", of { azimuths[it % n] }),
                Column("light_elevation", "degrees", of { options.light(elevations[it / n]) }),
                Column("light_azimuth", "degrees", of { ObservedRows.degrees(lines[it].lightAzimuth) }),
                Column("phase_angle", "degrees", of { options.phase(elevations[it / n]) }),
            ) + both("transmission", measure::transmission) +
                both("single_scattering") { measure.transmission(it) + 1 } + both("i_over_f", measure::total),
        ).write(study.tables)
    }

    private fun byElevation(): List<Column> {
        fun both(name: String, unit: String, average: (Int) -> BlockAverage?) = listOf(
            Column(name, unit, DoubleArray(elevations.size) { average(it)?.mean ?: Double.NaN }),
            Column(
                "${name}_error",
                unit,
                DoubleArray(elevations.size) { i -> average(i)?.let { study.judgement.error(it) } ?: Double.NaN },
            ),
        )
        return listOf(Column("elevation", "degrees", elevations)) +
            both("i_over_f", "") { means[it] } +
            both("asymmetry", "") { asymmetries[it]?.amplitude } +
            both("darkest_before_ansa", "degrees") { i ->
                asymmetries[i]?.takeIf(::isSeen)?.let { it.minimum * (HALF / PI) }
            }
    }

    private companion object {
        const val HALF = 180.0

        const val ANSAE = " At 90° and 270° the eye sees an ansa; as a particle moves on, A becomes smaller."

        /** An axis over a whole turn. */
        val TURN = List(9) { it * HALF / 4 }.let { NamedMarks(Ticks(it, it.map(ReportText::short)), 0.0, 2 * HALF) }

        /** Elevations that have rows on the page. */
        const val MOST_ROWS = 8
    }
}
