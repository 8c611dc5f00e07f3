package daphnis.analysis.report

import daphnis.analysis.insitu.State
import daphnis.analysis.occultation.Footprint
import daphnis.analysis.occultation.LightCurve
import daphnis.analysis.occultation.LineOfSight
import daphnis.analysis.occultation.PhotonCounts
import daphnis.analysis.occultation.RandomDiscs
import daphnis.analysis.occultation.Scan
import daphnis.analysis.occultation.ScanStatistics
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.core.input.InputException

/** Light curves of a star behind the patch as an instrument of finite resolution sees it, and their moments. */
internal class ScanPart(private val study: Study, footprint: Footprint) : LightPart {
    private val options = study.options
    private val line = LineOfSight.degrees(options.elevation, options.azimuth)
    private val scan = Scan(line, footprint, Math.toRadians(options.occultation.scanPath))
    private val photons = options.occultation.photons?.let { PhotonCounts(it) }
    private val statistics = ScanStatistics(unocculted = options.occultation.photons)
    private lateinit var last: LightCurve

    init {
        for (boundary in study.boxes.boundaries) {
            val why = scan.problem(boundary) ?: continue
            throw InputException("footprint", null, "is ${said(footprint)}: $why", isArgument = true)
        }
    }

    override fun add(state: State) {
        last = scan.of(state).let { if (photons == null) it else it.counted(photons) }
        statistics.add(last)
    }

    override fun rows(): List<NumberRow> {
        val excess = statistics.excessVariance()
        val rows = NumberRows()
        rows.average(null, "mean transmission of the scans", statistics.mean(), "")
        rows.average(null, "variance", statistics.variance(), "")
        if (photons != null) rows.average(null, "excess variance", excess, "", "less that of the photons")
        rows.exact(null, "variance of as many random spheres", alone, "", "opaque, overlapping, of the same sizes")
        rows.average(null, "excess variance over that", excess * (1 / alone), "")
        rows.average(null, "skewness", statistics.skewness(), "")
        rows.average(null, "excess kurtosis", statistics.kurtosis(), "")
        val length = length()
        val isShort = statistics.autocorrelationLength().mean < statistics.step
        val note = if (isShort) "shorter than a footprint" else "to 1/e"
        rows.average(null, "autocorrelation length along the path", length, study.units.length, note)
        return study.judgement.shown(rows.list())
    }

    /** Of what is longer than a footprint; that of shorter things is not in the light, but the footprint's own is. */
    private fun length(): BlockAverage {
        val length = statistics.autocorrelationLength()
        return if (length.mean >= statistics.step) length else BlockAverage(Double.NaN, Double.NaN, 0, 0.0)
    }

    override fun write(page: ReportPage) {
        page.numbers(rows())
        curve(page)
        autocorrelation(page)
        Table("occultation-scan-moments", columns()).write(study.tables)
    }

    /** The variance that the spheres of the last state would have at random places. */
    private val alone: Double by lazy {
        val p = study.last.population
        RandomDiscs(p.radius.copyOf(p.size), study.last.area, line).variance(scan.footprint, scan.path)
    }

    private fun columns(): List<Column> {
        fun one(value: Double) = doubleArrayOf(value)
        val averages = listOf(
            "mean" to statistics.mean(),
            "variance" to statistics.variance(),
            "excess_variance" to statistics.excessVariance(),
            "skewness" to statistics.skewness(),
            "kurtosis" to statistics.kurtosis(),
        )
        val length = length()
        return averages.flatMap { (name, average) ->
            listOf(
                Column(name, "", one(average.mean)),
                Column("${name}_error", "", one(study.judgement.error(average))),
            )
        } + listOf(
            Column("random_variance", "", one(alone)),
            Column("autocorrelation_length", study.units.length, one(length.mean)),
            Column("autocorrelation_length_error", study.units.length, one(study.judgement.error(length))),
        )
    }

    /** The tracks of the last state: the first is drawn, as many as a table has room for are written. */
    private fun curve(page: ReportPage) {
        val tracks = last.transmission
        val first = tracks[0]
        val place = DoubleArray(first.size) { (it + 0.5) * last.step }
        val unit = if (photons == null) "transmission" else "counts over those without a patch"
        val figure = Chart.lines(listOf(Curve("last state", place, first)), study.lengthAxis("along the path"), unit)
        val degrees = ReportText.short(options.occultation.scanPath)
        val caption =
            "Light curve of one track through the last state, as an instrument sees it whose footprint is " +
                "${said(scan.footprint)}. Its path lies $degrees° from x toward y."
        study.draw(page, figure, "occultation-scan", "light curve of a track", caption)
        val written = maxOf(1, minOf(tracks.size, MOST_ROWS / first.size))
        val n = first.size
        Table(
            "occultation-scan",
            listOf(
                Column("track", "", DoubleArray(written * n) { (it / n).toDouble() }),
                Column("distance", study.units.length, DoubleArray(written * n) { place[it % n] }),
                Column("transmission", "", DoubleArray(written * n) { tracks[it / n][it % n] }),
            ),
        ).write(study.tables)
    }

    private fun said(footprint: Footprint): String {
        fun length(value: Double) = "${ReportText.short(value)} ${study.units.length}".trimEnd()
        if (footprint.isDisc) return "a disc of diameter ${length(footprint.length)}"
        return "${length(footprint.length)} × ${length(footprint.width)}"
    }

    private fun autocorrelation(page: ReportPage) {
        val n = statistics.lagCount
        if (n < FEWEST_LAGS) return
        val all = List(n) { statistics.autocorrelation(it) }
        val lag = DoubleArray(n) { it * statistics.step }
        val mean = DoubleArray(n) { all[it].mean }
        val error = study.judgement.errors(DoubleArray(n) { all[it].error })
        val curve = Curve("autocorrelation", lag, mean, error)
        val figure = Chart.lines(
            listOf(curve),
            study.lengthAxis("lag along the path"),
            "autocorrelation",
            horizontal = 0.0,
        )
        val caption = "Autocorrelation of the light along the path, over the excess variance. ${study.judgement.bars()}"
        study.draw(page, figure, "occultation-autocorrelation", "autocorrelation of the light", caption)
        Table(
            "occultation-autocorrelation",
            listOf(
                Column("lag", study.units.length, lag),
                Column("autocorrelation", "", mean),
                Column("autocorrelation_error", "", error),
            ),
        ).write(study.tables)
    }

    private companion object {
        const val FEWEST_LAGS = 3
        const val MOST_ROWS = 100_000
    }
}
