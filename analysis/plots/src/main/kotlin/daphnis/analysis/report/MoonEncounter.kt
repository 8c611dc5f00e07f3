package daphnis.analysis.report

import daphnis.analysis.streamline.Encounter
import daphnis.analysis.table.UnitNames
import daphnis.core.boundary.Box
import daphnis.core.hill.Moon
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.scenario.Scenario

/** The passage of a scenario's moon by its patch: the [Encounter] it makes, and its rows in the report. */
internal object MoonEncounter {
    /** The moons of [scenario], in its order. */
    fun moons(scenario: Scenario?): List<Moon> = scenario?.forces?.filterIsInstance<Moon>().orEmpty()

    /**
     * Of a [moon] with the middle of [box], among these [orbits]; null without a moon, and where the unit of length
     * is not known or the moon is in the middle.
     */
    fun of(
        scenario: Scenario?,
        orbits: OrbitalFrequencies,
        box: Box,
        moon: Moon? = moons(scenario).firstOrNull(),
    ): Encounter? {
        if (scenario == null || moon == null) return null
        val planet = scenario.frame?.gravitationalParameter(scenario.units) ?: return null
        val ratio = moon.massRatio(scenario.units, planet) ?: return null
        val distance = (box.lowerX + box.upperX) / 2 - moon.x
        // The moon pulls by μ GM where orbits take 2π/Ω, which is what the frame knows of its distance.
        val axis = Math.cbrt(planet / (orbits.omega * orbits.omega))
        return if (distance == 0.0) null else Encounter(distance, ratio, axis, moon.e, orbits)
    }

    /** @param period orbits between two passages, of the run; null where it is not known */
    fun rows(e: Encounter, box: Box, units: UnitNames, period: Double?): List<NumberRow> {
        val rows = ArrayList<NumberRow>()
        val moonX = (box.lowerX + box.upperX) / 2 - e.distance
        val swings = "${ReportText.short(e.moonE)} ${units.length}"
        val swing = "of the guiding centres; the moon swings $swings to either side"
        rows.number(
            "distance from the moon's orbit, middle of the patch",
            e.distance,
            units.length,
            if (e.moonE > 0) swing else "",
        )
        rows.number(if (e.isKeplerian) "wavelength 3π|Δa|" else "wavelength 2π (s/κ) |Δa|", e.wavelength, units.length)
        amplitudes(rows, e, units)
        period?.let { rows.number("time between passages", it, "orbits") }
        val resonances = e.resonances(box.lowerX - moonX, box.upperX - moonX).size.toDouble()
        rows.number("resonances (m+1):m in the patch", resonances, "")
        return rows
    }

    private fun amplitudes(rows: MutableList<NumberRow>, e: Encounter, units: UnitNames) {
        val name = "amplitude a·e of one passage"
        val crossing = "streamlines cross without damping after"
        val place = "by the moon's place on its epicycle at the passage"
        if (e.moonE == 0.0) {
            rows.number(name, e.amplitude, units.length)
            rows.number(crossing, e.crossing(e.amplitude), units.length)
        } else if (e.largestAmplitude.isNaN()) {
            val why = "not known: the moon's epicycle reaches the middle of the patch"
            rows.number(name, Double.NaN, units.length, why)
        } else {
            rows.number("$name, least", e.leastAmplitude, units.length, place)
            rows.number("$name, largest", e.largestAmplitude, units.length, place)
            rows.number(crossing, e.crossing(e.largestAmplitude), units.length, "where the amplitude is largest")
        }
    }

    private fun MutableList<NumberRow>.number(name: String, value: Double, unit: String, note: String = "") {
        this += NumberRow(name, value, Double.NaN, unit, note = note)
    }
}
