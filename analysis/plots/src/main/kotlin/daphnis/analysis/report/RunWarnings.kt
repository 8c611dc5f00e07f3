package daphnis.analysis.report

import daphnis.core.input.InputException
import daphnis.core.run.Summary
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.scenario.warnings
import java.util.Locale
import kotlin.math.abs

/** Why the numbers of a run may not be those that were wanted, in sentences. */
internal object RunWarnings {
    /** Of the run of [study] and the [rows] of its numbers; none for a file or the run of a program. */
    fun of(study: Study, rows: List<NumberRow>): List<String> {
        val scenario = study.physics?.takeIf { study.input.directory != null } ?: return emptyList()
        val ofNumbers = listOfNotNull(resting(study.input.summary), imbalance(scenario, rows))
        return ofRun(study, scenario) + DrivenWalls.inStep(scenario) + ofNumbers
    }

    /** Where the guard decides how many collisions there are, and not the law of restitution. */
    private fun resting(summary: Summary?): String? {
        val part = (summary ?: return null).guardActivations / summary.collisions.toDouble()
        if (!(part > MOST_GUARDED)) return null
        val percent = "%.0f".format(Locale.ROOT, 100 * part)
        return "The collapse guard made $percent % of the collisions elastic, as where spheres rest on each other, " +
            "or where its bound is not small: how many collisions there are is its choice more than the spheres'."
    }

    /** What the run warned of when it began; none where its scenario, accepted with a loss, is none any more. */
    private fun ofRun(study: Study, scenario: Scenario): List<String> {
        val setup = try {
            ScenarioSetup.of(scenario, study.input.name, study.input.state(0).population)
        } catch (_: InputException) {
            return emptyList()
        }
        // They begin with the key of the scenario that is to blame.
        return warnings(setup).map { "The run warned: ${it.substringAfter(": ")}." }
    }

    /** In a steady state shear does the work that collisions dissipate, unless other forces work too. */
    private fun imbalance(scenario: Scenario, rows: List<NumberRow>): String? {
        if (scenario.forces.any { !it.isAmongAll }) return null
        val balance = rows.find { it.key == "shear_work_over_dissipation" } ?: return null
        return if (isOff(balance.value, balance.error)) {
            "Shear does ${ReportText.withError(balance.value, balance.error)} of the work that collisions dissipate, " +
                "which is 1 in a steady state: the time step is too long or the run is not steady."
        } else {
            null
        }
    }

    /**
     * Whether the [balance] of energy is away from 1 by more than chance and rounding make it; not without an [error].
     */
    fun isOff(balance: Double, error: Double): Boolean = abs(balance - 1) > maxOf(MOST_ERRORS * error, MOST_PART)

    private const val MOST_ERRORS = 5
    private const val MOST_GUARDED = 0.1
    private const val MOST_PART = 0.01
}
