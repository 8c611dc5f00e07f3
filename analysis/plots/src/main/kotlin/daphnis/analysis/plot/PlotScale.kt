package daphnis.analysis.plot

import daphnis.analysis.table.UnitNames
import daphnis.core.population.Population
import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.ResolvedScenario
import kotlin.math.PI

/**
 * In what plots over time count: in Hill's frame orbits and r Ω, so that steady states look alike whatever the distance
 * from the planet; else the scenario's units.
 *
 * @param omega angular speed of Hill's frame, null without one
 * @param meanRadius r, of the particles without bodies
 * @property units names of the scenario's units
 */
public class PlotScale(public val units: UnitNames, omega: Double?, meanRadius: Double) {
    /** Length of one unit of time of the plots, an orbit or 1. */
    public val time: Double = if (omega == null) 1.0 else 2 * PI / omega
    public val timeName: String = if (omega == null) units.time else "orbits"

    /** One unit of speed of the plots, r Ω or 1. */
    public val speed: Double = if (omega == null) 1.0 else meanRadius * omega
    public val speedName: String = if (omega == null) units.speed else "r Ω"

    /** One unit of angular speed of the plots, Ω or 1. */
    public val spin: Double = omega ?: 1.0
    public val spinName: String = if (omega == null) units.rate else "Ω"
    public val temperatureName: String = if (omega == null) units.temperature else "(r Ω)^2"
    public val rateName: String = if (omega == null) units.rate else "1/orbit"

    public companion object {
        /** Of the [scenario] of a run, with the spheres it began with. */
        @JvmStatic
        public fun of(scenario: ResolvedScenario, population: Population): PlotScale {
            val particles = (0 until population.size).filter { !scenario.isBody(population.id[it]) }
            val radius = if (particles.isEmpty()) 1.0 else particles.map { population.radius[it] }.average()
            return PlotScale(UnitNames(scenario.units), FrameSetup.angularSpeed(scenario, scenario.name), radius)
        }
    }
}
