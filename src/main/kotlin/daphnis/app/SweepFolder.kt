package daphnis.app

import daphnis.analysis.sweep.SweepRun
import daphnis.app.sweep.PlannedRun
import daphnis.app.sweep.SweepDirectory
import daphnis.app.sweep.SweepOrder
import daphnis.app.sweep.SweepPlan
import daphnis.app.sweep.SweepRecord
import daphnis.core.scenario.Scenario
import java.nio.file.Path

/**
 * A sweep in its directory, for programs that carry out its runs themselves: on other machines, in any order, each by
 * `daphnis.core.run.Run`. The directory is as that of `daphnis sweep`.
 */
public class SweepFolder private constructor(private val order: SweepOrder) {
    /** A run that belongs to the sweep. */
    public class Task internal constructor(run: PlannedRun, scenario: Scenario, directory: Path) {
        /** Readable and different from those of all others. */
        public val name: String = run.name

        /** Its scenario, with the seed; threads are 0, which is one per core. */
        public val scenario: Scenario = scenario

        /** The directory that is its place. */
        public val directory: Path = directory
    }

    /** All runs, in the order of the plan. */
    public val tasks: List<Task> = order.plan.runs.map { Task(it, order.scenarioOf(it), order.place.run(it.name)) }

    /**
     * Makes the tables and plots of all runs that are finished.
     *
     * @param from averages begin at this time; null for three eighths of each run
     * @return what a user should know, a line each: runs that are missing, failed, or not of this sweep
     */
    public fun collect(from: Double?): List<String> {
        val notices = ArrayList<String>()
        order.place.claim(order.record, mayHaveRuns = true).use {
            val found: List<SweepRun> = SweepRuns(order, null, from, quiet = true).collect(order.plan.runs)
            notices += order.missing(found)
            for (run in found) run.failure?.let { why -> notices += "${run.name}: $why" }
            if (found.isNotEmpty()) SweepReport(order, quiet = true).write(found) { line -> notices += line }
        }
        return notices
    }

    public companion object {
        /**
         * Makes [directory] that of a sweep, or joins the same sweep that is there.
         *
         * @param title what to call the [scenario]
         * @param settings `path=value,value,…` each, values as JSON, as for `--set` of `daphnis sweep`
         * @param seeds such as `1..8`; null for the scenario's alone
         * @throws daphnis.core.input.InputException when something is wrong with them, or there is something else
         */
        @JvmStatic
        public fun make(
            scenario: Scenario,
            title: String,
            settings: List<String>,
            seeds: String?,
            engine: String?,
            directory: Path,
        ): SweepFolder {
            val record = SweepRecord.of(scenario, SweepPlan.of(settings, seeds), title)
            val order = orderOf(SweepDirectory(directory), record, engine)
            order.requireStartable(allEngines)
            order.place.join(record)
            return SweepFolder(order)
        }

        /** The sweep that is in [directory]. @throws daphnis.core.input.InputException when there is none */
        @JvmStatic
        public fun open(directory: Path): SweepFolder = SweepDirectory(directory).let {
            SweepFolder(orderOf(it, it.known(), engine = null))
        }

        private fun orderOf(place: SweepDirectory, record: SweepRecord, engine: String?) =
            SweepOrder(place, record, engine) { changedBy(it) }
    }
}
