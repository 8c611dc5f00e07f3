package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.collision.GuardSpec
import daphnis.core.population.granularTemperature
import daphnis.core.scenario.Scenario
import java.nio.file.Files
import kotlin.math.ln
import kotlin.math.sqrt

/** A run that loses energy in collisions at every speed while nothing heats it never becomes steady. */
internal object FreeCooling {
    /** Whether the scenario says so; a scenario that was given for space, time and units only does not. */
    fun isSeen(input: AnalysisInput): Boolean {
        val directory = input.directory ?: return false
        if (!Files.exists(directory.scenario)) return false
        return input.scenario?.let { isOf(it, dispersionAtEnd(input)) } == true
    }

    /** @param dispersion of velocities along an axis, at the end of the run */
    fun isOf(scenario: Scenario, dispersion: Double): Boolean {
        if (isDriven(scenario)) return false
        return scenario.impacts.any { it.roughness?.loses == true } ||
            scenario.impacts.any { it.restitution!!.losesAlways } &&
            !isElastic(scenario.guard, dispersion)
    }

    /**
     * Whether most impacts are elastic already. In a gas the normal component of the relative velocity at an impact has
     * the density g exp(−g²/4σ²), so half of the impacts are slower than 2σ √ln 2.
     */
    private fun isElastic(guard: GuardSpec?, dispersion: Double): Boolean =
        guard != null && guard.floor(dispersion) > 2 * sqrt(ln(2.0)) * dispersion

    private fun dispersionAtEnd(input: AnalysisInput): Double {
        val last = input.state(input.size - 1)
        return sqrt(granularTemperature(last.population, last.boundary))
    }

    /** An acceleration that is the same everywhere heats nothing; gravity of spheres can. */
    private fun isDriven(scenario: Scenario): Boolean = scenario.frame != null ||
        scenario.boundary.drives ||
        scenario.forces.any { it.heats }
}
