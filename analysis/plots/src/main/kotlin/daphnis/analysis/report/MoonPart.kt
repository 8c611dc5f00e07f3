package daphnis.analysis.report

import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.streamline.Streamlines
import daphnis.core.hill.Epicycle
import daphnis.core.hill.Moon
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.scenario.FrameSetup
import kotlin.math.sign

/** What the [moon] of a scenario does to streamlines; nothing but its place where its encounter is not known. */
internal class MoonPart private constructor(
    private val study: Study,
    moons: List<Moon>,
    private val orbits: OrbitalFrequencies,
) {
    private val units = study.units
    private val last = study.last
    private val all = moons.mapIndexed { k, moon -> seen(moon, -1 - k) }
    private val moon = all.first()
    private val others = all.drop(1)
    private val encounter = MoonEncounter.of(study.input.scenario, orbits, last.boundary.box, moon)

    /** Where the moon is along the orbit, at the time of the last state. */
    val y: Double = now(moon).state(orbits)[1]

    /** Where all moons are at the time of the last state, in words: they are no spheres, and mostly beside the patch. */
    val standing: String
        get() {
            val places = all.joinToString(" and ") { moon ->
                val at = now(moon).state(orbits)
                "x = ${ReportText.short(at[0])}, y = ${ReportText.short(at[1])} ${units.length}"
            }
            return "${if (all.size == 1) "The satellite, not drawn, is" else "Satellites, not drawn, are"} at $places."
        }

    /** [moon] where the ring has pulled it, if it feels that and the run has rows with this [number]; else as given. */
    private fun seen(moon: Moon, number: Int): Moon {
        val now = study.input.bodies.find { it.id == number }?.orbit(last.time, orbits) ?: return moon
        return object : Moon by moon {
            override val x = now.guidingX
            override val e = now.e
            override val inclination = now.i
            override val orbit = now
            override val epoch = last.time
        }
    }

    private fun now(moon: Moon): Epicycle {
        val now = moon.orbit.after(last.time - moon.epoch, orbits)
        val distance = study.input.scenario?.let { FrameSetup.distance(it, orbits) }
        return if (moon.returns && distance != null) now.onCircle(2 * Math.PI * distance) else now
    }

    /** What an axis along the orbit says. */
    val azimuth: String = "azimuth from the moon [${units.length}]"

    /** Multiples of the wavelength behind the moon, as azimuths from it. */
    fun marks(): List<Double> {
        val e = encounter ?: return emptyList()
        return (0..(last.boundary.box.length(1) / e.wavelength).toInt()).map { -it * e.wavelength * sign(e.distance) }
    }

    /** Forced eccentricities of [lines], and the numbers of the encounter. */
    fun write(page: ReportPage, lines: Streamlines) {
        val e = encounter ?: return
        val curves = listOf(0, lines.groups / 2, lines.groups - 1).distinct().map { g ->
            val guiding = (0 until lines.slabs).map { lines.guidingX[lines.at(it, g)] }.filter { !it.isNaN() }.average()
            Curve(
                "x = ${ReportText.short(guiding)} ${units.length}",
                DoubleArray(lines.slabs) { lines.meanY[lines.at(it, g)] - y },
                DoubleArray(lines.slabs) { lines.forcedE[lines.at(it, g)] },
            )
        }
        val label = "forced eccentricity [${units.length}]"
        val figure = Chart.lines(curves, azimuth, label, horizontal = e.amplitude)
        val caption =
            "Forced eccentricity |⟨e·exp(iφ)⟩| along the ring; dashed: the impulse of one passage of a moon on " +
                "a circle, 2.2396 μ a³/Δa², for the middle of the patch. The box repeats along the orbit: what is " +
                "ahead of the moon may have passed it before, what is far behind not yet."
        study.draw(page, figure, "forced-eccentricity", "forced eccentricity along the ring", caption)
        page.numbers(MoonEncounter.rows(e, last.boundary.box, units, period(moon)))
        if (moon.inclination > 0) {
            val swing = "${ReportText.short(moon.inclination)} ${units.length}"
            page.paragraph("The satellite leaves the plane by up to $swing; amplitudes are those of one in the plane.")
        }
        others.forEachIndexed { k, moon ->
            page.paragraph("Satellite ${k + 2}, whose passages are in the same picture:")
            val encounter = MoonEncounter.of(study.input.scenario, orbits, last.boundary.box, moon)
            encounter?.let { page.numbers(MoonEncounter.rows(it, last.boundary.box, units, period(moon))) }
        }
    }

    private fun period(moon: Moon) =
        study.input.scenario?.let { FrameSetup.distance(it, orbits) }?.let { moon.orbitsBetweenPassages(it, orbits) }

    companion object {
        /** Of the first satellite of the scenario; null without one, or without Hill's frame. */
        fun of(study: Study): MoonPart? {
            val moons = MoonEncounter.moons(study.input.scenario).ifEmpty { return null }
            return study.input.frequencies?.let { MoonPart(study, moons, it) }
        }
    }
}
