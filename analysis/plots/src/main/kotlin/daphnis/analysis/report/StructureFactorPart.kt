package daphnis.analysis.report

import daphnis.analysis.correlation.StructureFactor
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State

/** The structure factor of the plane. */
internal class StructureFactorPart(private val study: Study) : Part {
    private val factor = StructureFactor(farthest(), BINS)
    private val averages = Averages(factor)

    private fun farthest(): Double {
        val box = study.boxes.mean
        val shortest = minOf(box.length(0), box.length(1))
        return minOf(2 * Math.PI / (2 * study.bulk.typicalRadius) * 2, 2 * Math.PI / shortest * 60)
    }

    override fun add(state: State) = averages.add(state)

    override fun write(page: ReportPage) {
        val unit = study.units.waveNumber
        val curve = AveragedCurve("structure-factor", "structure factor", "S", "wave number |k|", "k", unit)
        val x = DoubleArray(factor.bins) { factor.centre(it) }
        val caption = "Structure factor S(k) of wave vectors in the plane, averaged over directions; " +
            "1 for particles without correlation."
        val critical = (2 * Math.PI / study.bulk.criticalWavelength).takeIf { it.isFinite() }
        val mark = if (critical == null) "" else " The upright line is Toomre's critical wavelength."
        curve.write(study, page, x, averages, caption + mark, critical)
    }

    private companion object {
        const val BINS = 60
    }
}
