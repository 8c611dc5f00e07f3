package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.State
import daphnis.analysis.order.RadialKey
import daphnis.analysis.order.RadialOrder
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.Figures
import daphnis.analysis.streamline.Encounter
import daphnis.analysis.streamline.Streamlines
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.core.scenario.ForceSpec
import java.nio.file.Path

/** Streamlines of the last state, in both orders; relative to the moon where there is one. */
internal class StreamlineSection(
    private val input: AnalysisInput,
    private val plots: Path,
    private val tables: Path,
    private val options: AnalysisOptions,
) {
    private val units = input.units
    private val moon = input.scenario?.forces?.filterIsInstance<ForceSpec.Satellite>()?.firstOrNull()

    fun write(page: ReportPage, last: State) {
        val n = last.population.size
        val groups = if (options.groups > 0) {
            options.groups
        } else {
            Math.sqrt(n / PARTICLES_A_GROUP / 4).toInt().coerceIn(4, 40)
        }
        val slabs = if (options.slabs > 0) options.slabs else (n / PARTICLES_A_GROUP / groups).toInt().coerceIn(4, 400)
        val order = RadialOrder()
        val byPosition = Streamlines.of(last, slabs, groups, RadialKey.X, order)
        val byGuiding = Streamlines.of(last, slabs, groups, RadialKey.GUIDING_CENTRE, order)
        table("streamlines-x", byPosition)
        table("streamlines-guiding-centre", byGuiding)
        val moonY = moon?.let { moonAt(last) } ?: 0.0
        val label = if (moon != null) "azimuth from the moon [${units.length}]" else "azimuth y [${units.length}]"
        draw(page, "streamlines", byGuiding, label, moonY, last)
        val k = groups / 2
        if (moon != null) encounter(page, byGuiding, label, moonY, last)
        val forced = (0 until slabs).map { byGuiding.forcedE[byGuiding.at(it, k)] }.filter { !it.isNaN() }
        if (forced.isEmpty()) return
        page.paragraph(
            "$slabs slabs of azimuth, $groups groups of equal count in each, sorted by guiding centre. Forced eccentricity of the middle streamline " +
                "${ReportText.short(forced.average())} ${units.length} on average; largest q = ${ReportText.short(
                    byGuiding.q.filter { !it.isNaN() }.maxOrNull() ?: Double.NaN,
                )} " +
                "(streamlines cross where q reaches 1; the scatter of few particles raises it). Tables: streamlines-x.csv, streamlines-guiding-centre.csv.",
        )
    }

    private fun moonAt(last: State): Double {
        val m = moon!!
        val orbit = daphnis.core.hill.Epicycle(m.x, m.y, m.e, m.phase)
        val omega = last.omega!!
        return orbit.after(last.time, omega).state(omega)[1]
    }

    private fun draw(page: ReportPage, name: String, lines: Streamlines, label: String, moonY: Double, last: State) {
        val drawn = (0 until lines.groups).filter { it % maxOf(1, lines.groups / MOST_LINES) == 0 }
        val curves = drawn.map { g ->
            Curve(
                "$g",
                DoubleArray(lines.slabs) { lines.meanY[lines.at(it, g)] - moonY },
                DoubleArray(lines.slabs) { lines.meanX[lines.at(it, g)] },
            )
        }
        val marks = encounterOf(last)?.let { e ->
            (0..(last.boundary.box.length(1) / e.wavelength).toInt()).map {
                -it * e.wavelength * Math.signum(e.distance)
            }
        }.orEmpty()
        val caption = if (moon != null) {
            "Streamlines by guiding centre; dashed: the moon and multiples of the wavelength 3π|Δa| behind it."
        } else {
            "Streamlines: the mean place of each group from slab to slab."
        }
        val box = last.boundary.box
        val low = box.lowerY - moonY
        val high = box.upperY - moonY
        page.svg(
            Figures.write(
                Chart.paths(
                    curves,
                    label,
                    "radial position x [${units.length}]",
                    marks.filter {
                        it in
                            low..high
                    },
                ),
                plots,
                name,
                Chart.WIDTH,
                HEIGHT,
            ),
            "streamlines",
            caption,
        )
    }

    private fun encounterOf(last: State): Encounter? = MoonEncounter.of(input.scenario, last.omega!!, last.boundary.box)

    private fun encounter(page: ReportPage, lines: Streamlines, label: String, moonY: Double, last: State) {
        val e = encounterOf(last) ?: return
        val drawn = listOf(0, lines.groups / 2, lines.groups - 1).distinct()
        val curves = drawn.map { g ->
            val name = "x = ${ReportText.short(
                (0 until lines.slabs).map {
                    lines.guidingX[lines.at(it, g)]
                }.filter { !it.isNaN() }.average(),
            )} ${units.length}"
            Curve(
                name,
                DoubleArray(lines.slabs) { lines.meanY[lines.at(it, g)] - moonY },
                DoubleArray(lines.slabs) { lines.forcedE[lines.at(it, g)] },
            )
        }
        page.svg(
            Figures.write(
                Chart.lines(curves, label, "forced eccentricity [${units.length}]", horizontal = e.amplitude),
                plots,
                "forced-eccentricity",
                Chart.WIDTH,
                Chart.HEIGHT,
            ),
            "forced eccentricity along the ring",
            "Forced eccentricity |⟨e·exp(iφ)⟩| along the ring; dashed: the impulse of one passage of a moon on a circle, 2.2396 μ a³/Δa², for the middle of the patch.",
        )
        page.numbers(MoonEncounter.rows(e, last.boundary.box, units))
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
        ).write(tables)
    }

    companion object {
        /** Particles below which groups mean nothing: two in each of the fewest. */
        const val LEAST = 32
        private const val PARTICLES_A_GROUP = 12.0
        private const val MOST_LINES = 24
        private const val HEIGHT = 420
    }
}
