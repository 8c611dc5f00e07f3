package daphnis.analysis.report

import daphnis.analysis.correlation.PairCorrelation
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.table.UnitNames

/** The pair correlation, in space or in the plane. */
internal class PairPart(private val study: Study) : Part {
    private val units = study.units
    private val isOfDiscs = study.last.boundary.space.isPlane
    private val isInPlane = PairCorrelation.isInPlane(study.last.boundary) && !isOfDiscs
    private val pairs = correlation()
    private val averages = Averages(pairs)

    private fun correlation(): PairCorrelation {
        val contact = study.bulk.nearestContact
        val room = study.boxes.boundaries.minOf { PairCorrelation.farthest(it) }
        val farthest = minOf(room, RADII * 2 * study.bulk.typicalRadius)
        val fromContact = !isInPlane && contact < farthest
        return PairCorrelation(farthest, BINS, if (fromContact) contact else 0.0)
    }

    override fun add(state: State) = averages.add(state)

    override fun write(page: ReportPage) {
        val argument = if (isInPlane) "distance in the plane" else "distance r"
        val curve = AveragedCurve("pair-correlation", "pair correlation", "g", argument, "r", units.length)
        val x = DoubleArray(pairs.bins) { pairs.centre(it) }
        curve.write(study, page, x, averages, text + farAway())
    }

    /** Why g does not tend to 1 where particles do not fill the patch evenly. */
    private fun farAway(): String {
        // That of a crystal swings about 1 at any distance.
        if (averages.size == 0 || study.mayFreeze) return ""
        val mean = (FAR until BINS).map { averages.average(it).mean }.average()
        if (!(mean - 1 > UNEVEN)) return ""
        val far = ReportText.short(mean)
        return " At the longest of these distances g is about $far, not 1, since the density varies over longer " +
            "distances than these: pairs are of particles, and more of them are where it is high."
    }

    private val text get() = when {
        isInPlane -> IN_PLANE
        isOfDiscs -> OF_DISCS + nearest()
        else -> IN_SPACE + nearest()
    }

    private fun nearest(): String {
        if (pairs.nearest <= 0) return ""
        val contact = UnitNames.amount(ReportText.short(pairs.nearest), units.length)
        return " Bins begin at the contact of the smallest ${if (isOfDiscs) "discs" else "spheres"}, $contact."
    }

    private companion object {
        const val RADII = 8.0
        const val BINS = 80

        /** The last eighth of the bins, and by how much g is to be above 1 there to be explained. */
        const val FAR = 70
        const val UNEVEN = 0.05
        const val IN_PLANE = "Pair correlation in the x-y plane: pairs at a distance seen along z, over those of " +
            "particles without correlation. Spheres one above the other are nearer than contact in this view, " +
            "so that g is not 0 there."
        const val OF_DISCS = "Radial distribution function of discs: pairs at a distance, over those of particles " +
            "without correlation."
        const val IN_SPACE = "Radial distribution function in space: pairs at a distance, over those of particles " +
            "without correlation."
    }
}
