package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.occultation.LineOfSight
import daphnis.analysis.occultation.Transmissions
import daphnis.analysis.occultation.WakeFit
import daphnis.analysis.occultation.WakeSection
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import kotlin.math.PI

/** The light through the patch over a grid of elevations and azimuths, and the bars that would let through as much. */
internal class TransmissionGridPart(private val study: Study) : LightPart {
    private val options = study.options.occultation
    private val elevations = options.elevations.sortedArray()
    private val azimuths = options.gridAzimuths
    private val grid = Transmissions(LineOfSight.grid(elevations, azimuths))
    private val light = Averages(grid)

    override fun add(state: State) = light.add(state)

    override fun write(page: ReportPage) {
        val transmission = List(light.width) { light.average(it) }
        val depth = transmission.mapIndexed { k, t -> grid.depth(k, t) }
        val curves = elevations.mapIndexed { i, elevation ->
            val own = depth.subList(i * azimuths.size, (i + 1) * azimuths.size)
            Curve(
                "B = ${ReportText.short(elevation)}°",
                azimuths,
                DoubleArray(own.size) { own[it].mean },
                study.judgement.errors(DoubleArray(own.size) { own[it].error }),
            )
        }
        val figure = Chart.lines(curves, "azimuth A [degrees]", "normal optical depth")
        val caption =
            "Normal optical depth −sin B · ln T by the azimuth A in which the rays climb, from x toward y, at " +
                "each elevation B. Half a turn on it is the same, seen from below. ${study.judgement.bars()}"
        study.draw(page, figure, "occultation-grid", "normal optical depth by azimuth and elevation", caption)
        table(transmission, depth)
        if (study.isRing) wakes(page)
    }

    private fun table(transmission: List<BlockAverage>, depth: List<BlockAverage>) {
        fun of(values: List<BlockAverage>, number: (BlockAverage) -> Double) =
            DoubleArray(values.size) { number(values[it]) }
        val n = azimuths.size
        Table(
            "occultation-grid",
            listOf(
                Column("elevation", "degrees", DoubleArray(transmission.size) { elevations[it / n] }),
                Column("azimuth", "degrees", DoubleArray(transmission.size) { azimuths[it % n] }),
                Column("transmission", "", of(transmission) { it.mean }),
                Column("transmission_error", "", of(transmission) { study.judgement.error(it) }),
                Column("optical_depth", "", of(depth) { it.mean }),
                Column("optical_depth_error", "", of(depth) { study.judgement.error(it) }),
            ),
        ).write(study.tables)
    }

    /** By section of the bars; none for too few lines. */
    private val fits: List<WakeFit> by lazy {
        val series = Array(light.width) { light.series(it) }
        WakeSection.entries.mapNotNull { WakeFit.of(grid.lines, series, it) }
    }

    override fun rows(): List<NumberRow> {
        val lines = NumberRows()
        for (k in grid.lines.indices) {
            val (elevation, azimuth) = elevations[k / azimuths.size] to azimuths[k % azimuths.size]
            val name = "transmission at ${ReportText.short(elevation)}°, ${ReportText.short(azimuth)}°"
            lines.average(null, name, light.average(k), "")
        }
        val ellipse = fits.firstOrNull()?.takeIf { study.isRing && it.isSeen && !it.isNegligible }
        return study.judgement.shown(lines.list()) + ellipse?.let(::rows).orEmpty()
    }

    private fun rows(ellipse: WakeFit): List<NumberRow> {
        val rows = NumberRows()
        val bars = "elliptic bars"
        rows.average(null, "optical depth τ_G of the gaps between wakes", ellipse.gapDepth, "", bars)
        rows.average(null, "width of gaps over that of wakes, S/W", ellipse.gapOverWidth, "", bars)
        rows.average(null, "height over width of wakes, H/W", ellipse.heightOverWidth, "", bars)
        rows.average(null, "pitch angle of these bars", ellipse.pitch * (180 / PI), "degrees", TRAILING)
        rows.exact(null, "root mean square of T less that of the bars", ellipse.misfit, "")
        return study.judgement.shown(rows.list())
    }

    private fun wakes(page: ReportPage) {
        val ellipse = fits.firstOrNull()
        if (ellipse == null) {
            page.paragraph("No bars are fitted: it takes three azimuths and two elevations.")
        } else if (!ellipse.isSeen) {
            page.paragraph(
                "No bars are fitted: the light does not depend on the azimuth by more than chance makes it, or there " +
                    "are too few states to tell.",
            )
        } else if (ellipse.isNegligible) {
            val percent = ReportText.short(100 * WakeFit.LEAST_SHARE)
            page.paragraph(
                "No bars are given: the light depends on the azimuth, but too weakly for wakes. The bars that come " +
                    "nearest would cover less than $percent % of the plane.",
            )
        } else {
            page.numbers(rows(ellipse))
            page.paragraph(MODEL)
            Table("occultation-wakes", fits.zip(WakeSection.entries).flatMap { columns(it.first, it.second) })
                .write(study.tables)
        }
    }

    private fun columns(fit: WakeFit, section: WakeSection): List<Column> {
        val prefix = section.name.lowercase()
        fun both(name: String, unit: String, average: BlockAverage) = listOf(
            Column("${prefix}_$name", unit, doubleArrayOf(average.mean)),
            Column("${prefix}_${name}_error", unit, doubleArrayOf(study.judgement.error(average))),
        )
        return both("gap_depth", "", fit.gapDepth) + both("gap_over_width", "", fit.gapOverWidth) +
            both("height_over_width", "", fit.heightOverWidth) + both("pitch", "degrees", fit.pitch * (180 / PI)) +
            Column("${prefix}_misfit", "", doubleArrayOf(fit.misfit))
    }

    private companion object {
        const val TRAILING = "from the orbit, trailing positive"

        const val MODEL =
            "Wakes as opaque elliptic bars with a haze in the gaps between them (Hedman et al. 2007, AJ 133, 2624). " +
                "± is over the states; that wakes are no bars is not in it."
    }
}
