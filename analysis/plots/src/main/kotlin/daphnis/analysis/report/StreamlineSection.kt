package daphnis.analysis.report

import daphnis.analysis.order.RadialKey
import daphnis.analysis.order.RadialOrder
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.streamline.Streamlines
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import java.util.Locale
import kotlin.math.exp
import kotlin.math.ln

/** Streamlines of the last state, in both orders; relative to the moon where there is one. */
internal class StreamlineSection(private val study: Study) : Section {
    private val units = study.units
    private val last = study.last
    private val moon = MoonPart.of(study)
    private val groups =
        chosen(study.options.groups) { Math.sqrt(it / PARTICLES_PER_GROUP / 4).toInt().coerceIn(4, 40) }
    private val slabs = chosen(study.options.slabs) { (it / PARTICLES_PER_GROUP / groups).toInt().coerceIn(4, 400) }

    override val heading = "Streamlines"
    override val over = study.overLast
    override val applies = study.isRing && study.input.hasVelocities
    override val leftOut = when {
        PerturbedSheet.isSeen(last) -> "in a perturbed sheet all streamlines are alike"
        study.isThin -> "the patch is too thin for slabs of azimuth: their streamlines are noise"
        else -> study.tooFew(LEAST)
    }

    /** What is [asked] for, else by the number of spheres. */
    private inline fun chosen(asked: Int, suitable: (Int) -> Int) =
        if (asked > 0) asked else suitable(last.population.size)

    override fun write(page: ReportPage) {
        val order = RadialOrder()
        val byPosition = Streamlines.of(last, slabs, groups, RadialKey.X, order)
        val lines = Streamlines.of(last, slabs, groups, RadialKey.GUIDING_CENTRE, order)
        table("streamlines-x", byPosition)
        table("streamlines-guiding-centre", lines)
        draw(page, lines)
        moon?.write(page, lines)
        val forced = (0 until slabs).map { lines.forcedEUnbiased[lines.at(it, groups / 2)] }.filter { !it.isNaN() }
        if (forced.isEmpty()) return
        val largest = ReportText.short(lines.q.filter { !it.isNaN() }.maxOrNull() ?: Double.NaN)
        page.paragraph(
            "$slabs slabs of azimuth, $groups groups of equal count in each, sorted by guiding centre. " +
                "${middle(forced)} Largest q = $largest (streamlines cross where q reaches 1; the scatter of few " +
                "particles raises it). " +
                "Tables: streamlines-x.csv, streamlines-guiding-centre.csv.",
        )
    }

    /** Of the middle streamline, by slab, without what random epicycles make. */
    private fun middle(forced: List<Double>): String {
        if (isNoise(forced.size, forced.count { it == 0.0 })) {
            return "The middle streamline has no forced eccentricity beyond what as many random epicycles make."
        }
        val mean = "${ReportText.short(forced.average())} ${units.length}"
        return "Forced eccentricity a·e of the middle streamline, without that of random epicycles: $mean on average."
    }

    private fun draw(page: ReportPage, lines: Streamlines) {
        val y = moon?.y ?: 0.0
        val drawn = (0 until lines.groups).filter { it % maxOf(1, lines.groups / MOST_LINES) == 0 }
        val runs = StreamlineRuns(lines, drawn)
        if (runs.part < LEAST_PART) {
            page.paragraph(
                "No picture of streamlines: most of them cross, as around a moon inside the patch, or where few " +
                    "particles scatter more than streamlines are apart.",
            )
            return
        }
        val curves = runs.list.map { (g, slabs) ->
            Curve(
                "$g",
                slabs.map { lines.meanY[lines.at(it, g)] - y }.toDoubleArray(),
                slabs.map { lines.meanX[lines.at(it, g)] }.toDoubleArray(),
            )
        }
        val box = last.boundary.box
        val marks = moon?.marks().orEmpty().filter { it in box.lowerY - y..box.upperY - y }
        val azimuth = moon?.azimuth ?: "azimuth y [${units.length}]"
        val figure = Chart.paths(curves, azimuth, "radial position x [${units.length}]", marks)
        val caption = if (moon != null) {
            "Streamlines by guiding centre; dashed: the moon and multiples of the wavelength 3π|Δa| behind it."
        } else {
            "Streamlines: the mean place of each group from slab to slab."
        }
        study.draw(page, figure, "streamlines", "streamlines", caption + left(runs.part), HEIGHT)
    }

    private fun left(part: Double): String {
        if (part >= 1) return ""
        val percent = String.format(Locale.ROOT, "%.0f", maxOf(1.0, 100 * (1 - part)))
        return " Where one crosses the next, on $percent % of their length, neither is drawn."
    }

    private fun table(name: String, s: Streamlines) {
        val n = s.slabs * s.groups
        Table(
            name,
            listOf(
                Column("slab", "", DoubleArray(n) { (it / s.groups).toDouble() }),
                Column("group", "", DoubleArray(n) { (it % s.groups).toDouble() }),
                Column("count", "", DoubleArray(n) { s.count[it].toDouble() }),
                Column("mean_x", units.length, s.meanX),
                Column("mean_y", units.length, s.meanY),
                Column("min_x", units.length, s.minX),
                Column("max_x", units.length, s.maxX),
                Column("guiding_x", units.length, s.guidingX),
                Column("optical_depth", "", s.opticalDepth),
                Column("mean_e", units.length, s.meanE),
                Column("mean_i", units.length, s.meanI),
                Column("phase", "rad", s.phase),
                Column("forced_e", units.length, s.forcedE),
                Column("dispersion", units.speed, s.dispersion),
                Column("q", "", s.q),
                Column("spacing", units.length, s.spacing),
                Column("mean_x_error", units.length, s.meanXError),
                Column("optical_depth_error", "", s.opticalDepthError),
                Column("mean_e_error", units.length, s.meanEError),
                Column("mean_i_error", units.length, s.meanIError),
                Column("phase_error", "rad", s.phaseError),
                Column("forced_e_error", units.length, s.forcedEError),
                Column("forced_e_unbiased", units.length, s.forcedEUnbiased),
                Column("dispersion_error", units.speed, s.dispersionError),
                Column("q_error", "", s.qError),
            ),
        ).write(study.tables)
    }

    companion object {
        /** Particles below which groups mean nothing: two in each of the fewest. */
        private const val LEAST = 32
        private const val PARTICLES_PER_GROUP = 12.0
        private const val MOST_LINES = 24
        private const val HEIGHT = 420

        /** Chance above which forced eccentricities are taken for noise. */
        private const val LEAST_CHANCE = 0.01

        /** Part of the streamlines below which there is no picture of them. */
        private const val LEAST_PART = 0.5

        /** Whether [zeros] of [slabs] without forced eccentricity may be as few by chance: of noise 1 − 1/e of all are. */
        fun isNoise(slabs: Int, zeros: Int): Boolean {
            val each = 1 - exp(-1.0)
            // In logarithms: of many slabs the first terms are below the smallest number.
            var term = -slabs.toDouble()
            var sum = 0.0
            for (k in 0..zeros) {
                sum += exp(term)
                term += ln((slabs - k) / (k + 1.0) * each / (1 - each))
            }
            return sum > LEAST_CHANCE
        }
    }
}
