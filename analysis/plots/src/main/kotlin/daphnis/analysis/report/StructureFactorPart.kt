package daphnis.analysis.report

import daphnis.analysis.correlation.SpatialStructureFactor
import daphnis.analysis.correlation.StructureFactor
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Curve
import daphnis.analysis.theory.PercusYevick

/** The structure factor: of waves in space in a box that repeats along all axes, else of waves in the plane. */
internal class StructureFactorPart(private val study: Study, private val groups: NamedGroups?) : Part {
    private val isSpatial = !study.isRing &&
        (0 until study.last.dimensions).all { axis -> study.boxes.boundaries.all { it.hasImages(axis) } }
    private val largest = if (isSpatial) farthestInSpace() else farthest()
    private val spatial = if (isSpatial) SpatialStructureFactor(largest, BINS, NamedGroups.of(groups)) else null
    private val plane = StructureFactor(largest, BINS)
    private val averages = Averages(spatial ?: plane)

    /** Of each state where waves lean, and of one where all have the same. */
    private val waveNumbers = ArrayList<DoubleArray>()
    private val x by lazy { DoubleArray(BINS) { bin -> waveNumbers.sumOf { it[bin] } / waveNumbers.size } }

    private fun farthest(): Double {
        val box = study.boxes.mean
        val shortest = minOf(box.length(0), box.length(1))
        return minOf(PEAKS / study.bulk.typicalRadius, 2 * Math.PI / shortest * 60)
    }

    /** Bounded so that wave vectors can be listed in a moment. */
    private fun farthestInSpace(): Double {
        val box = study.boxes.mean
        val axes = study.last.dimensions
        val cell = (0 until axes).fold(1.0) { v, axis -> v * 2 * Math.PI / box.length(axis) }
        val ball = if (axes == 2) Math.PI else 4 * Math.PI / 3
        return minOf(PEAKS / study.bulk.typicalRadius, Math.pow(2 * MOST_LISTED * cell / ball, 1.0 / axes))
    }

    override fun add(state: State) {
        averages.add(state)
        if (waveNumbers.isEmpty() || state.boundary.shear != null || study.boxes.isChanging) {
            waveNumbers += spatial?.waveNumbers(state) ?: plane.waveNumbers(state)
        }
    }

    override fun write(page: ReportPage) {
        val unit = study.units.waveNumber
        val curve = AveragedCurve("structure-factor", "structure factor", "S", "wave number |k|", "k", unit)
        val where = if (isSpatial && study.last.dimensions == 3) "in space" else "in the plane"
        val caption = "Structure factor S(k) of wave vectors $where, averaged over directions; " +
            "1 for particles without correlation."
        val critical = (2 * Math.PI / study.bulk.criticalWavelength).takeIf { it.isFinite() }
        val mark = if (critical == null) "" else " The upright line is Toomre's critical wavelength."
        val theory = theory()
        val known = if (theory == null) "" else " $BESIDE"
        val crystal = if (isSpatial && study.mayFreeze) " $CRYSTAL" else ""
        curve.write(study, page, x, averages, caption + mark + known + crystal, critical, theory)
        val s = spatial ?: return
        groups?.write(study, page, "structure-factor", x, averages, "S", "wave number |k|" to unit, "k", PARTIAL) {
                a,
                b,
            ->
            s.first(a, b)
        }
    }

    /** Of the fluid of equal elastic spheres. */
    private fun theory(): Curve? {
        val filling = study.bulk.fillingFactor
        val scenario = study.physics ?: return null
        val isKnown = isSpatial &&
            study.last.dimensions == 3 &&
            ElasticGas.isSeen(scenario, study.last) &&
            filling <= PercusYevick.MOST_FILLED
        if (!isKnown) return null
        val diameter = 2 * study.bulk.meanRadius
        return Curve("Percus–Yevick", x, DoubleArray(BINS) { PercusYevick.structureFactor(x[it] * diameter, filling) })
    }

    private companion object {
        const val BINS = 60

        /** Largest wave number times the radius: four half waves in a radius. */
        const val PEAKS = 2 * Math.PI
        const val MOST_LISTED = 2e6
        const val BESIDE = "Percus & Yevick's S(k), with the diameter of Verlet & Weis 1972, stands beside it."
        const val CRYSTAL = "Of many particles some wave vectors are taken, so peaks of a crystal may be missing, " +
            "and each is lower, the more other vectors are in its bin."
        const val PARTIAL = "Partial structure factors S_ab(k) of Ashcroft & Langreth."
    }
}
