package daphnis.analysis.report

import daphnis.analysis.correlation.SurfaceMap
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table

/**
 * The autocorrelation of the surface density along x alone, of lags up to half the patch: for a patch so thin that all
 * that is in it varies along x only.
 */
internal class LinePart(private val study: Study) : Part {
    private val length = study.boxes.mean.length(0)
    private val cells = Math.rint(length / (2 * study.bulk.typicalRadius)).toInt().coerceIn(2, MOST_CELLS)
    private val lags = cells / 2
    private val averages = Averages(
        Measure { SurfaceMap.of(it, cells, 1).autocorrelation(lags, 0).copyOfRange(lags, 2 * lags + 1) },
    )

    override fun add(state: State) = averages.add(state)

    override fun write(page: ReportPage) {
        if (averages.size == 0) return
        val x = DoubleArray(lags + 1) { it * length / cells }
        val all = x.indices.map { averages.average(it) }
        val y = DoubleArray(x.size) { all[it].mean }
        val error = DoubleArray(x.size) { study.judgement.error(all[it]) }
        // That of a cell with itself is the noise of counting and would hide the rest.
        val shown = Curve("A", x.drop(1).toDoubleArray(), y.drop(1).toDoubleArray(), error.drop(1).toDoubleArray())
        val figure = Chart.lines(listOf(shown), study.lengthAxis("Δx"), "autocorrelation A", horizontal = 0.0)
        val caption = "Autocorrelation A of the surface density along x, ⟨δΣ δΣ⟩/⟨Σ⟩², the density averaged along " +
            "the orbit. ${study.judgement.bars()}"
        study.draw(page, figure, "autocorrelation-x", "autocorrelation of the surface density along x", caption)
        val unit = study.units.length
        Table("autocorrelation-x", listOf(Column("dx", unit, x), Column("A", "", y), Column("A_error", "", error)))
            .write(study.tables)
    }

    private companion object {
        const val MOST_CELLS = 400
    }
}
