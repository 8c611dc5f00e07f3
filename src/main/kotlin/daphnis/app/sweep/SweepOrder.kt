package daphnis.app.sweep

import daphnis.core.scenario.Scenario

/**
 * A sweep that is asked for.
 *
 * @property title what the scenario is called
 * @property label what an axis calls a key
 */
internal class SweepOrder(
    val plan: SweepPlan,
    val place: SweepDirectory,
    val record: SweepRecord,
    val title: String,
    val label: KeyLabel,
    private val scenarios: Map<PlannedRun, Scenario>,
) {
    fun scenarioOf(run: PlannedRun): Scenario = scenarios.getValue(run)
}
