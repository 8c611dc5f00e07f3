package daphnis.analysis.report

import daphnis.analysis.insitu.State

/** Correlations of particle positions: pairs, waves, the surface density and its wakes. */
internal class StructureSection(study: Study) : Section {
    private val surface = SurfacePart(study)
    private val parts = listOf(PairPart(study), StructureFactorPart(study), surface)

    override val heading = "Structure"
    override val over = "Correlations of particle positions. ${study.overAverages}"
    override val leftOut =
        if (study.isCompact) study.tooFew() else "the patch is more than twenty times as long as wide"

    override fun add(state: State) {
        if (leftOut == null) for (part in parts) part.add(state)
    }

    override fun ownNumbers() = surface.rows()

    override fun write(page: ReportPage) {
        for (part in parts) part.write(page)
    }
}
