package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.occultation.RayCasting
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import kotlin.math.PI

/** A part of [OccultationSection]. */
internal interface LightPart : Part {
    /** Its numbers as the page shows them. */
    fun rows(): List<NumberRow>
}

/** What a star behind the patch would show. */
internal class OccultationSection(private val study: Study) : Section {
    private val options = study.options
    private val casting = RayCasting(Math.toRadians(options.elevation), Math.toRadians(options.azimuth))

    /** Share of the rays that come through, then by place along x. */
    private val light =
        Averages({ state -> casting.cast(state).let { doubleArrayOf(it.transmission) + places(it.scan()) } })

    override val heading = "Occultation"
    override val over = "What a star behind the ${study.place} would show. ${study.overAverages}"

    // Of grains in a box nobody wants it, unless they say so.
    override val applies = study.isRing || study.isLit || options.occultation.isAsked
    override val leftOut = study.unlit

    /** What is asked for beside. */
    private val parts: List<LightPart> = if (leftOut != null) {
        emptyList()
    } else {
        listOfNotNull(
            if (options.occultation.elevations.isEmpty()) null else TransmissionGridPart(study),
            options.occultation.footprint?.let { ScanPart(study, it) },
            options.occultation.observed?.let { ObservedPart(study, it) },
        )
    }

    /** As many places as in the first state, which in a box that changes may have more or fewer rays. */
    private fun places(scan: DoubleArray): DoubleArray {
        val n = if (light.size == 0) scan.size else light.width - 1
        return DoubleArray(n) { scan[(it.toLong() * scan.size / n).toInt()] }
    }

    override fun add(state: State) {
        if (leftOut != null) return
        light.add(state)
        for (part in parts) part.add(state)
    }

    override fun ownNumbers(): List<NumberRow> =
        if (leftOut != null) emptyList() else study.judgement.shown(rows()) + parts.flatMap { it.rows() }

    private val rays: String
        get() = "${ReportText.short(options.elevation)}° elevation and ${ReportText.short(options.azimuth)}° azimuth"

    private fun rows(): List<NumberRow> {
        val transmission = light.average(0)
        val rows = NumberRows()
        rows.average(null, "rays that come through at $rays", transmission, "")
        depth(rows, transmission)
        val radii = study.last.population.radius
        val hasBodies = study.last.population.size > study.bulk.particles
        val note = if (hasBodies) "bodies included, which block light too" else ""
        rows.exact(null, "geometric optical depth", radii.sumOf { PI * it * it } / study.last.meanArea, "", note)
        return rows.list()
    }

    override fun write(page: ReportPage) {
        page.numbers(study.judgement.shown(rows()))
        scan(page)
        for (part in parts) part.write(page)
    }

    private fun depth(rows: NumberRows, transmission: BlockAverage) {
        val name = "normal optical depth −sin B · ln T"
        if (transmission.mean > 0) {
            rows.average(null, name, casting.depth(transmission), "", "T averaged over the states first")
        } else {
            rows.exact(null, name, Double.NaN, "", "opaque: no ray comes through")
        }
    }

    private fun scan(page: ReportPage) {
        val n = light.width - 1
        if (n < FEWEST_PLACES) {
            page.paragraph(
                "No scan along x: the ${study.place} is so long for its width that too few rays pass side by side.",
            )
            return
        }
        val box = study.boxes.mean
        val x = DoubleArray(n) { box.lowerX + (it + 0.5) * box.length(0) / n }
        val last = DoubleArray(n) { light.series(1 + it).last() }
        val mean = DoubleArray(n) { light.average(1 + it).mean }
        val length = study.units.length
        val label = UnitNames.axis(if (study.isRing) "radial position x" else "x", length)
        val figure = Chart.lines(listOf(Curve("last state", x, last), Curve("mean", x, mean)), label, "transmission")
        val caption = "Synthetic occultation: share of the light that comes through along y at each x, from rays " +
            "through the particles, bodies and their images at $rays, which is the direction in the plane in which " +
            "they climb, from x toward y."
        study.draw(page, figure, "occultation", "synthetic occultation", caption)
        Table(
            "occultation",
            listOf(
                Column("x", length, x),
                Column("transmission_last", "", last),
                Column("transmission_mean", "", mean),
            ),
        ).write(study.tables)
    }

    private companion object {
        /** Places along x below which a scan shows nothing. */
        const val FEWEST_PLACES = 8
    }
}
