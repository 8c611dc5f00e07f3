package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import daphnis.analysis.sweep.Sweep
import daphnis.analysis.sweep.SweepPlots
import daphnis.analysis.sweep.SweepRun
import daphnis.analysis.sweep.SweepTables
import daphnis.analysis.sweep.SweepText
import daphnis.app.printing.printLine
import daphnis.app.printing.printLines
import daphnis.app.printing.reasonInWords
import daphnis.app.printing.warn
import daphnis.app.sweep.KeyLabel
import daphnis.app.sweep.PlannedRun
import daphnis.app.sweep.SharedCores
import daphnis.app.sweep.SweepDirectory
import daphnis.app.sweep.SweepPlan
import daphnis.app.sweep.SweepRecord
import daphnis.app.sweep.SweepWork
import daphnis.core.format.WholeFile
import daphnis.core.input.InputException
import daphnis.core.run.RunDirectory
import daphnis.core.run.adviceOn
import daphnis.core.run.engineOf
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import kotlinx.serialization.json.Json
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.Callable
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors

/** `daphnis sweep`. */
class SweepCommand : CliktCommand(name = "sweep") {
    private val scenario by argument(
        help = "scenario file or built-in name",
        completionCandidates = Candidates.scenario,
    )
    private val settings by option(
        "--set",
        metavar = "path=value,…",
        help = "values of a key of the scenario; several lists give all combinations. A comma within brackets, " +
            "braces or quotation marks belongs to the value: 'box.lengths=[9,9,9],[12,12,12]'",
        completionCandidates = Candidates.setting,
    ).multiple()
    private val seeds by option(
        "--seeds",
        metavar = "from..to",
        help = "seeds of each combination, such as 1..8 or 1,5,9 (default: the scenario's alone)",
    )
    private val jobs by option("--jobs", help = "runs at a time, which share the cores (default: one per core)").int()
    private val engine by option(
        "--engine",
        help = "collision engine: ${allEngines.names.joinToString()}",
        completionCandidates = Candidates.engine,
    )
    private val from by option(
        "--from",
        help = "averages begin at this time, in the scenario's unit of time (default: after 3/8 of each run)",
    ).double()
    private val out by option(
        "--out",
        metavar = "dir",
        help = "directory of the sweep, new or with the same sweep, which goes on (default: runs/NAME-sweep)",
        completionCandidates = Candidates.files,
    )
    private val quiet by option("--quiet", help = "no progress").flag()

    override fun help(context: Context) =
        "Run a scenario for many values and seeds, and tabulate and plot the means with their errors."

    override fun run() {
        val jobs = jobs
        if (jobs != null && jobs !in 1..MOST_JOBS) {
            throw InputException("--jobs", null, "is $jobs; it must be in 1..$MOST_JOBS")
        }
        from?.let { if (!it.isFinite()) throw InputException("--from", null, "is $it; it must be a finite number") }
        val plan = SweepPlan.of(settings, seeds)
        val base = scenarioNamed(scenario, emptyList())
        // A file that is changed later changes no run.
        val scenarios = plan.runs.associateWith { scenarioOf(it) }
        requireEngine()
        val place = SweepDirectory(
            out?.let { pathOf(it, "--out") } ?: Path.of("runs").resolve("${directoryName(base.name)}-sweep"),
        )
        requireStartable(plan, place, scenarios::getValue)
        val record = SweepRecord(Json.parseToJsonElement(ScenarioJson.write(base)), plan.keys, plan.seeds)
        writing(place.path.toAbsolutePath().parent) {
            place.claim(record)
        }.use { lock ->
            lock.notice?.let(::warn)
            carryOut(plan, place, KeyLabel(base.units), scenarios::getValue)
        }
    }

    private fun scenarioOf(run: PlannedRun): Scenario {
        val seed = listOfNotNull(run.seed?.let { "seed=$it" })
        val shorthand = listOfNotNull(engine?.let { "engine.name=$it" })
        // Threads are shared out, unless the command line says how many.
        val words = listOf("engine.threads=0") + run.settings + shorthand + seed
        return scenarioNamed(scenario, words).changedBy(run.settings + seed)
    }

    private fun requireEngine() {
        val name = engine ?: return
        if (name in allEngines.names) return
        throw InputException("--engine", null, "'$name' is no engine; ${adviceOn(name, allEngines)}")
    }

    /** Wrong values are told before anything is written; seeds change none. Runs that have begun were checked then. */
    private fun requireStartable(plan: SweepPlan, place: SweepDirectory, scenarioOf: (PlannedRun) -> Scenario) {
        val begun = { run: PlannedRun -> Files.exists(RunDirectory(place.run(run.name)).scenario) }
        for (run in plan.runs.filterNot(begun).distinctBy { it.settings }) {
            try {
                ScenarioSetup.check(scenarioOf(run), scenario)
                engineOf(scenarioOf(run), scenario, allEngines).close()
            } catch (e: InputException) {
                // What is wrong with one key may be so only together with others.
                val others = plan.varying.indices.filter { plan.varying[it].path != e.key }
                    .map { "${plan.varying[it].path}=${run.values[it]}" }
                val where = if (others.isEmpty()) "" else "; this is with ${others.joinToString(", ")}"
                throw InputException("", null, reasonInWords(e) + where)
            }
        }
    }

    private fun carryOut(
        plan: SweepPlan,
        place: SweepDirectory,
        label: KeyLabel,
        scenarios: (PlannedRun) -> Scenario,
    ) {
        val runs = plan.runs
        val cores = Runtime.getRuntime().availableProcessors()
        val together = minOf(jobs ?: cores, runs.size)
        val progress = SweepProgress(quiet, runs.size)
        val interruption = Interruption()
        preparePlot()
        try {
            val engines = SharedCores(allEngines, maxOf(1, cores / together))
            val work = SweepWork(
                place,
                engines,
                scenarios,
                scenario,
                from,
                progress,
                ::reasonInWords,
                ::drawPlot,
            ) { interruption.requested }
            interruption.armed = true
            val results = inParallel(runs, together) { run ->
                progress.begun(run)
                work.carryOut(run).also { progress.ended(run, it) }
            }
            progress.clear()
            val done = results.filterNotNull()
            if (done.size < runs.size) {
                val finished = done.count { it.failure == null }
                printLine(
                    "interrupted with $finished of ${runs.size} runs finished; the same command goes on with them",
                )
                throw ProgramResult(EXIT_INTERRUPTED)
            }
            val keys = plan.varying.map { it.path }
            conclude(Sweep(keys, done, keys.map { label.of(it) }), place)
            if (interruption.requested) {
                printLine("interrupted at the end: the sweep is complete")
                throw ProgramResult(EXIT_INTERRUPTED)
            }
        } finally {
            interruption.done()
        }
    }

    /** What [act] makes of each of [runs], in their order, [jobs] at a time. */
    private fun inParallel(runs: List<PlannedRun>, jobs: Int, act: (PlannedRun) -> SweepRun?): List<SweepRun?> {
        val pool = Executors.newFixedThreadPool(jobs) { Thread(it, "daphnis-sweep").apply { isDaemon = true } }
        try {
            return runs.map { pool.submit(Callable { act(it) }) }.map { it.get() }
        } catch (e: ExecutionException) {
            throw e.cause ?: e
        } finally {
            pool.shutdownNow()
        }
    }

    private fun conclude(sweep: Sweep, place: SweepDirectory) {
        printLines(table(SweepText(sweep)))
        var plots = 0
        writing(place.path) {
            val tables = SweepTables(sweep)
            tables.writeMeans(place.means)
            tables.writeRuns(place.runs)
            WholeFile.write(place.text, "# $scenario\n\n${SweepText(sweep).text(WIDE)}\n")
            val drawn = SweepPlots(sweep)
            plots = drawn.write(place.plots)
            drawn.missing?.let { warn("there are no PNG pictures in ${place.plots}, only SVG: $it") }
        }
        if (!quiet) {
            printLine("")
            printLine("${if (plots == 0) "tables" else "tables and plots"} are in ${place.path}")
        }
        val failed = sweep.failed.size
        if (failed > 0) {
            throw ProgramResult(complain("$failed of ${sweep.runs.size} runs failed, see ${place.runs}", EXIT_FAILED))
        }
    }

    /** Beside each other stand as many points as have place; where not even one has, all are listed below. */
    private fun table(sweep: SweepText): String {
        val columns = outputColumns() ?: return sweep.text(WIDE)
        val text = sweep.text(columns)
        return fitted(if (isWide(text.lines(), columns)) sweep.text(Int.MAX_VALUE) else text, columns)
    }

    private companion object {
        const val MOST_JOBS = 1000

        /** Columns of a table where there is no terminal. */
        const val WIDE = 120
    }
}
