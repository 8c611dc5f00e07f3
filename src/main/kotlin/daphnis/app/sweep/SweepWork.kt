package daphnis.app.sweep

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.report.Analysis
import daphnis.analysis.report.AnalysisOptions
import daphnis.analysis.report.ReportNumber
import daphnis.analysis.series.SeriesTable
import daphnis.analysis.sweep.SweepRun
import daphnis.analysis.table.UnitNames
import daphnis.core.Output
import daphnis.core.engine.EngineFactory
import daphnis.core.format.FormatException
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import daphnis.core.population.Population
import daphnis.core.run.Run
import daphnis.core.run.RunDirectory
import daphnis.core.run.RunRecord
import daphnis.core.run.Summary
import daphnis.core.run.differences
import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.ResolvedScenario
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import java.nio.file.Files
import java.nio.file.Path

/** What a run of a sweep tells while it is carried out, on the thread that does so. */
internal interface SweepTeller {
    /** Run [name] has come so far, from 0 to 1. */
    fun at(name: String, fraction: Double)

    /** Another process is at run [name]. */
    fun busy(name: String)

    /** Something of run [name] that a user should know. */
    fun notice(name: String, line: String)
}

/**
 * Carries out one run of a sweep after the other, from wherever each is: not begun, begun, or finished.
 *
 * @param scenarioOf the scenario of a run; what is wrong with it was told before
 * @param source what to call the scenario in messages
 * @param from averages begin at this time; null for three eighths of the run
 * @param words what went wrong, in a line
 * @param plot draws what is at the end of a run with a series, whose spheres began as given, or tells why not
 */
internal class SweepWork(
    private val directory: SweepDirectory,
    private val engines: EngineFactory,
    private val scenarioOf: (PlannedRun) -> Scenario,
    private val source: String,
    private val from: Double?,
    private val teller: SweepTeller,
    private val words: (Throwable) -> String,
    private val plot: (RunDirectory, ResolvedScenario, Population, tell: (String) -> Unit) -> Unit,
    private val cancelled: () -> Boolean,
) {
    /** The [run] with its numbers, or with why it failed; null when it is cancelled before its end. */
    fun carryOut(run: PlannedRun): SweepRun? {
        if (cancelled()) return null
        directory.noteFailure(run.name, null)
        val result = resultOf(run) { place ->
            val wasFinished = isFinished(place)
            if (!wasFinished && !simulated(run, place)) return null
            teller.at(run.name, 1.0)
            if (wasFinished) drawMissing(run, place)
        }
        // None, too: another process may have noted that it could not have this run meanwhile.
        directory.noteFailure(run.name, result.failure)
        return result
    }

    /** The same of a [run] that is finished; null when it is not. */
    fun collected(run: PlannedRun): SweepRun? = resultOf(run) { place -> if (!isFinished(place)) return null }

    /** The [run] with its numbers, once [finish] has brought it to its end, or with why that failed. */
    private inline fun resultOf(run: PlannedRun, finish: (RunDirectory) -> Unit): SweepRun {
        val place = RunDirectory(directory.run(run.name))
        val seed = run.seed ?: scenarioOf(run).seed
        return try {
            requireOwn(run, place)
            finish(place)
            val (numbers, remark) = numbers(place)
            SweepRun(run.name, run.values, seed, numbers, null, remark)
        } catch (e: FormatException) {
            // Only a user can mend what is on the disk.
            teller.notice(run.name, words(e))
            SweepRun(run.name, run.values, seed, emptyList(), words(e))
        } catch (e: Throwable) {
            if (e is InputException && e.wayOut == WayOut.AWAIT_OTHER) teller.busy(run.name)
            // Whatever it is, the other runs go on: a run that ran out of memory leaves them theirs.
            SweepRun(run.name, run.values, seed, emptyList(), words(e))
        }
    }

    /** What was put in the place of a run by hand, or resumed to another end, is not averaged with the others. */
    private fun requireOwn(run: PlannedRun, place: RunDirectory) {
        if (!Files.exists(place.scenario)) {
            if (Files.exists(place.program)) throw FormatException("${place.path} holds the run of a program; $MEND")
            return
        }
        val scenario = scenarioOf(run)
        differences(place, scenario, source).firstOrNull()?.let {
            throw FormatException("${place.path} holds another run than that of this sweep: $it; $MEND")
        }
        val has = end(ScenarioJson.read(place.scenario))
        val should = end(scenario)
        if (has == should) return
        throw FormatException(
            "${place.path} was resumed to until=$has, and the runs of this sweep end at until=$should; $MEND",
        )
    }

    private fun end(scenario: Scenario): Double = FrameSetup.times(scenario, source).end

    private fun isFinished(place: RunDirectory): Boolean {
        if (!Files.exists(place.scenario)) return false
        return try {
            Run.open(place.path).summary()?.finished ?: false
        } catch (e: FormatException) {
            throw FormatException("${e.message}; $MEND")
        }
    }

    /** Whether the run came to its end. */
    private fun simulated(run: PlannedRun, place: RunDirectory): Boolean {
        val begun = if (Files.exists(place.scenario)) {
            Run.resume(place.path, engines = engines)
        } else {
            Run.start(scenarioOf(run), source, place.path, engines = engines)
        }
        begun.use {
            for (notice in it.notices) teller.notice(run.name, notice)
            val start = it.simulation.runStart
            val watcher = Output { s -> teller.at(run.name, part(s.time - start, it.until - start)) }
            val summary = it.execute(watcher) { cancelled() }
            val scenario = it.scenario
            if (summary.finished && it.hasSeries && scenario != null) {
                plot(place, scenario, it.simulation.population) { why -> teller.notice(run.name, why) }
            }
            return summary.finished
        }
    }

    /** A sweep that was killed may have left a finished run without its plot. A missing plot is no failure of the run. */
    private fun drawMissing(run: PlannedRun, place: RunDirectory) {
        if (!Files.exists(place.series) || Files.exists(place.plots.resolve(LAST_PLOT))) return
        try {
            val setup = ScenarioSetup.of(scenarioOf(run), source)
            plot(place, setup.scenario, setup.population) { teller.notice(run.name, it) }
        } catch (e: Exception) {
            teller.notice(run.name, "no plot: ${words(e)}; the run is complete")
        }
    }

    private fun part(done: Double, all: Double) = if (all > 0) (done / all).coerceIn(0.0, 1.0) else 1.0

    /** The numbers of a finished run, and what is to be said of those that are missing. */
    private fun numbers(place: RunDirectory): Pair<List<ReportNumber>, String?> = try {
        val input = AnalysisInput.ofRun(place.path)
        val ofReport = Analysis(input, AnalysisOptions(from)).numbers()
        ofReport + atEnd(place.path, input.units) to null
    } catch (e: InputException) {
        if (e.wayOut == WayOut.ANALYSE_WITH_LOSS) {
            throw FormatException(e.message("", "bring it back; $MEND"))
        }
        val units = UnitNames(ScenarioJson.read(place.scenario).units)
        atEnd(place.path, units) to "no numbers of the report: ${words(e).removePrefix("${place.path}: ")}"
    }

    private fun atEnd(path: Path, units: UnitNames): List<ReportNumber> {
        val series = RunDirectory(path).series
        return if (Files.exists(series)) ReportNumber.atEnd(SeriesTable.read(series), units) else emptyList()
    }

    private companion object {
        /** The file that is written last of the plot of a run. */
        const val LAST_PLOT = "run.png"
        const val MEND = "without the directory it is done again"
    }
}
