package daphnis.analysis.report

import daphnis.analysis.streamline.Encounter
import daphnis.analysis.table.UnitNames
import daphnis.core.boundary.Box
import daphnis.core.scenario.ForceSpec
import daphnis.core.scenario.FrameSpec
import daphnis.core.scenario.Scenario

/** The passage of a scenario's moon by its patch: the [Encounter] it makes, and its rows in the report. */
internal object MoonEncounter {
    /**
     * For the middle of [box], in a frame of angular speed [omega]; null without a moon, and where the unit of length
     * is not known or the moon is in the middle.
     */
    fun of(scenario: Scenario?, omega: Double, box: Box): Encounter? {
        val moon = scenario?.forces?.filterIsInstance<ForceSpec.Satellite>()?.firstOrNull() ?: return null
        val frame = scenario.frame as? FrameSpec.Hill ?: return null
        val metres = scenario.units.lengthInMetres ?: return null
        val planet = scenario.units.gravitationalParameter(frame.planet) ?: return null
        val constant = scenario.units.gravitationalConstant ?: return null
        val ratio = moon.massRatio ?: moon.mass?.let { it * constant / planet } ?: return null
        // Kepler, where the frame is given by its angular speed.
        val frameAxis = frame.distanceInKm?.let { it * METRES_PER_KM / metres } ?: Math.cbrt(planet / (omega * omega))
        val distance = (box.lowerX + box.upperX) / 2 - moon.x
        return if (distance == 0.0) null else Encounter(distance, ratio, frameAxis + moon.x, moon.e)
    }

    fun rows(e: Encounter, box: Box, units: UnitNames): List<NumberRow> {
        val moonX = (box.lowerX + box.upperX) / 2 - e.distance
        val swing = if (e.moonE > 0) {
            "of the guiding centres; the moon swings ${ReportText.short(e.moonE)} ${units.length} to either side"
        } else {
            ""
        }
        return listOf(
            NumberRow(
                "distance from the moon's orbit, middle of the patch",
                e.distance,
                Double.NaN,
                units.length,
                note = swing,
            ),
            NumberRow("wavelength 3π|Δa|", e.wavelength, Double.NaN, units.length),
        ) + amplitudes(e, units) + listOf(
            NumberRow("time between passages", e.synodicOrbits, Double.NaN, "orbits"),
            NumberRow(
                "resonances (m+1):m in the patch",
                e.resonances(box.lowerX - moonX, box.upperX - moonX).size.toDouble(),
                Double.NaN,
                "",
            ),
        )
    }

    private fun amplitudes(e: Encounter, units: UnitNames): List<NumberRow> {
        val what = "amplitude a·e of one passage"
        val crossing = "streamlines cross without damping after"
        if (e.moonE == 0.0) {
            return listOf(
                NumberRow(what, e.amplitude, Double.NaN, units.length),
                NumberRow(crossing, e.crossing(e.amplitude), Double.NaN, units.length),
            )
        }
        val place = "by the moon's place on its epicycle at the passage"
        if (e.largestAmplitude.isNaN()) {
            return listOf(
                NumberRow(
                    what,
                    Double.NaN,
                    Double.NaN,
                    units.length,
                    note = "not known: the moon's epicycle reaches the middle of the patch",
                ),
            )
        }
        return listOf(
            NumberRow("$what, least", e.leastAmplitude, Double.NaN, units.length, note = place),
            NumberRow("$what, largest", e.largestAmplitude, Double.NaN, units.length, note = place),
            NumberRow(
                crossing,
                e.crossing(e.largestAmplitude),
                Double.NaN,
                units.length,
                note = "where the amplitude is largest",
            ),
        )
    }

    private const val METRES_PER_KM = 1000
}
