package daphnis.app.sweep

import daphnis.analysis.sweep.SweepRun
import daphnis.app.printing.reasonInWords
import daphnis.core.engine.EngineFactory
import daphnis.core.input.InputException
import daphnis.core.run.RunDirectory
import daphnis.core.run.engineOf
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioSetup
import java.nio.file.Files

/**
 * A sweep that is asked for.
 *
 * @param engine of all runs; null for the scenario's
 * @param changed says in a scenario's description what was set
 */
internal class SweepOrder(
    val place: SweepDirectory,
    val record: SweepRecord,
    engine: String?,
    changed: Scenario.(List<String>) -> Scenario,
) {
    val plan: SweepPlan = record.plan()

    /** What the scenario is called. */
    val title: String get() = record.name

    /** What an axis calls a key. */
    val label: KeyLabel = KeyLabel(record.scenario(emptyList()).units)

    private val scenarios = plan.runs.associateWith { run ->
        val seed = listOfNotNull(run.seed?.let { "seed=$it" })
        val shorthand = listOfNotNull(engine?.let { "engine.name=$it" })
        // Threads are shared out, unless the command line says how many.
        record.scenario(listOf("engine.threads=0") + run.settings + shorthand + seed).changed(run.settings + seed)
    }

    fun scenarioOf(run: PlannedRun): Scenario = scenarios.getValue(run)

    /** What is to be said of runs that are not among those [found], a line each. */
    fun missing(found: List<SweepRun>): List<String> =
        (plan.runs.map { it.name } - found.map { it.name }.toSet()).map { name ->
            "$name: is not finished" + place.failure(name)?.let { "; the last try failed: $it" }.orEmpty()
        }

    /**
     * Wrong values are told before anything is written; seeds change none. Runs that have begun were checked then.
     *
     * @throws InputException when a run could not start with one of the [engines]
     */
    fun requireStartable(engines: EngineFactory) {
        val begun = { run: PlannedRun -> Files.exists(RunDirectory(place.run(run.name)).scenario) }
        for (run in plan.runs.filterNot(begun).distinctBy { it.settings }) {
            try {
                ScenarioSetup.check(scenarioOf(run), title)
                engineOf(scenarioOf(run), title, engines).close()
            } catch (e: InputException) {
                // What is wrong with one key may be so only together with others.
                val others = plan.varying.indices.filter { plan.varying[it].path != e.key }
                    .map { "${plan.varying[it].path}=${run.values[it]}" }
                val where = if (others.isEmpty()) "" else "; this is with ${others.joinToString(", ")}"
                throw InputException("", null, reasonInWords(e) + where)
            }
        }
    }
}
