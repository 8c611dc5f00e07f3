package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.scenario.BoundarySpec
import daphnis.core.scenario.ForceSpec
import daphnis.core.scenario.RestitutionSpec
import daphnis.core.scenario.Scenario
import java.nio.file.Files

/** A run that loses energy in collisions at every speed while nothing heats it never becomes steady. */
internal object FreeCooling {
    /** Whether the scenario says so; a scenario that was given for space, time and units only does not. */
    fun isSeen(input: AnalysisInput): Boolean {
        val directory = input.directory ?: return false
        return Files.exists(directory.scenario) && input.scenario?.let { isOf(it) } == true
    }

    fun isOf(scenario: Scenario): Boolean {
        // Laws that are elastic for slow impacts come to an end of cooling.
        val law = scenario.restitution as? RestitutionSpec.Constant ?: return false
        return law.coefficient < 1 && !isDriven(scenario)
    }

    /** An acceleration that is the same everywhere heats nothing; gravity of spheres can. */
    private fun isDriven(scenario: Scenario): Boolean = scenario.frame != null ||
        isSheared(scenario.boundary) ||
        scenario.forces.any { it !is ForceSpec.UniformAcceleration }

    private fun isSheared(boundary: BoundarySpec): Boolean = when (boundary) {
        is BoundarySpec.LeesEdwards -> boundary.shearRate != 0.0
        is BoundarySpec.ShearedPeriodic -> boundary.velocityJump != 0.0
        is BoundarySpec.HillSheet -> true
        is BoundarySpec.Open, is BoundarySpec.Periodic, is BoundarySpec.Walls -> false
    }
}
