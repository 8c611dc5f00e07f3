package daphnis.analysis.report

import daphnis.analysis.insitu.State

/**
 * Correlations of particle positions: pairs, waves, the surface density and its wakes. Of a patch that is thin along
 * the orbit they are those along x: pairs would reach over half its width only, and wakes have no room to lean.
 */
internal class StructureSection(private val study: Study) : Section {
    private val surface = SurfacePart(study)
    private val kinds = if (study.isThin) null else NamedGroups.of(study)
    private val parts = if (study.isThin) {
        listOf(LinePart(study), StructureFactorPart(study, null))
    } else {
        listOfNotNull(
            PairPart(study),
            StructureFactorPart(study, kinds),
            kinds?.let { MixturePart(study, it) },
            surface,
        )
    }

    override val heading = "Structure"
    override val over = "Correlations of particle positions. ${study.overAverages}"
    override val leftOut = when {
        study.isRoomCut -> Study.ROOM_CUT
        study.isCompact || study.isThin -> study.tooFew()
        else -> "the ${study.place} is more than twenty times as long as wide"
    }

    override fun add(state: State) {
        if (leftOut == null) for (part in parts) part.add(state)
    }

    override fun ownNumbers() = if (study.isThin) emptyList() else surface.rows()

    override fun write(page: ReportPage) {
        for (part in parts) part.write(page)
    }
}
