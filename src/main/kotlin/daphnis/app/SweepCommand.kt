package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.optional
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import daphnis.app.printing.printLine
import daphnis.app.printing.warn
import daphnis.app.sweep.RunWords
import daphnis.app.sweep.SweepDirectory
import daphnis.app.sweep.SweepOrder
import daphnis.app.sweep.SweepPart
import daphnis.app.sweep.SweepPlan
import daphnis.app.sweep.SweepRecord
import daphnis.core.input.InputException
import daphnis.core.run.adviceOn
import java.nio.file.Path

/** `daphnis sweep`. */
class SweepCommand : CliktCommand(name = "sweep") {
    private val scenario by argument(
        help = "scenario file or built-in name (with --collect it may be left out)",
        completionCandidates = Candidates.scenario,
    ).optional()
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
    private val part by option(
        "--part",
        metavar = "k/n",
        help =
        "carry out only the runs number k, k+n, …, while other processes do the others; 'auto' is the task of a " +
            "SLURM array or of an indexed Kubernetes job",
    )
    private val collect by option("--collect", help = "make the tables of the finished runs; begins none").flag()
    private val list by option(
        "--list",
        help = "print number, name and command of each run, a line each; writes nothing",
    ).flag()
    private val quiet by option("--quiet", help = "no progress").flag()
    private val nodes by option("--nodes", "--cluster", hidden = true)

    override fun help(context: Context) =
        "Run a scenario for many values and seeds, and tabulate and plot the means with their errors."

    override fun run() {
        checkOptions()
        val part = part?.let { SweepPart.parse(it, System.getenv()) }
        val order = if (scenario == null) orderOfRecord() else orderOfCommand()
        val report = SweepReport(order, quiet)
        val runs = SweepRuns(order, jobs, from, quiet)
        when {
            list -> printList(order)
            collect -> collect(order, runs, report)
            part != null -> carryOut(order, part, runs, report)
            else -> carryOut(order, runs, report)
        }
    }

    private fun checkOptions() {
        if (nodes != null) {
            throw InputException("--nodes, --cluster", null, "are of one run; processes share a sweep out with --part")
        }
        val jobs = jobs
        if (jobs != null && jobs !in 1..MOST_JOBS) {
            throw InputException("--jobs", null, "is $jobs; it must be in 1..$MOST_JOBS")
        }
        from?.let { if (!it.isFinite()) throw InputException("--from", null, "is $it; it must be a finite number") }
        val modes = listOfNotNull(part?.let { "--part" }, "--collect".takeIf { collect }, "--list".takeIf { list })
        if (modes.size > 1) throw InputException(modes[0], null, "is given together with ${modes[1]}; $ONE_EACH")
        if (scenario != null) return
        if (!collect) throw InputException("scenario", null, "is missing: a file or a built-in name is needed")
        if (out == null) throw InputException("--out", null, "is missing: the directory of the sweep is needed")
        if (settings.isNotEmpty() || seeds != null) {
            throw InputException("scenario", null, "is missing, to which --set and --seeds belong; or leave them out")
        }
    }

    private fun orderOfCommand(): SweepOrder {
        val word = checkNotNull(scenario)
        val plan = SweepPlan.of(settings, seeds)
        // A file that is changed later changes no run.
        val base = scenarioNamed(word, emptyList())
        requireEngine()
        val place = out?.let { pathOf(it, "--out") } ?: Path.of("runs").resolve("${directoryName(base.name)}-sweep")
        return order(SweepDirectory(place), SweepRecord.of(base, plan, word))
    }

    /** The sweep that is in the directory. */
    private fun orderOfRecord(): SweepOrder {
        val place = SweepDirectory(pathOf(checkNotNull(out), "--out"))
        return order(place, place.known())
    }

    private fun order(place: SweepDirectory, record: SweepRecord) = SweepOrder(place, record, engine) { changedBy(it) }

    private fun printList(order: SweepOrder) {
        order.requireStartable(allEngines)
        val words = RunWords(order.title, engine)
        order.plan.runs.forEachIndexed { k, run ->
            printLine("${k + 1} ${run.name} ${words.of(run, order.place.run(run.name))}")
        }
    }

    private fun collect(order: SweepOrder, runs: SweepRuns, report: SweepReport) {
        if (!order.place.hasRuns) order.place.known()
        order.place.claim(order.record, mayHaveRuns = true).use { lock ->
            lock.notice?.let(::warn)
            val found = runs.collect(order.plan.runs)
            val missing = order.missing(found)
            for (line in missing) warn(line)
            if (found.isEmpty()) {
                throw ProgramResult(complain("none of the ${missing.size} runs is finished", EXIT_FAILED))
            }
            report.conclude(found)
            if (missing.isEmpty()) return
            val all = order.plan.runs.size
            throw ProgramResult(complain("${missing.size} of $all runs are missing in the tables", EXIT_FAILED))
        }
    }

    private fun carryOut(order: SweepOrder, part: SweepPart, runs: SweepRuns, report: SweepReport) {
        order.requireStartable(allEngines)
        writing(order.place.path.toAbsolutePath().parent) { order.place.join(order.record) }
        val own = part.of(order.plan.runs)
        runs.carryOut(own) { outcome ->
            requireDone(outcome, own.size)
            report.concludePart("$part", outcome.done, outcome.busy)
            if (outcome.isInterrupted) interrupted("the part is complete")
        }
    }

    private fun carryOut(order: SweepOrder, runs: SweepRuns, report: SweepReport) {
        order.requireStartable(allEngines)
        writing(order.place.path.toAbsolutePath().parent) {
            order.place.claim(order.record)
        }.use { lock ->
            lock.notice?.let(::warn)
            runs.carryOut(order.plan.runs) { outcome ->
                requireDone(outcome, order.plan.runs.size)
                report.conclude(outcome.done, outcome.busy)
                if (outcome.isInterrupted) interrupted("the sweep is complete")
            }
        }
    }

    private fun requireDone(outcome: SweepRuns.Outcome, all: Int) {
        if (outcome.done.size == all) return
        val finished = outcome.done.count { it.failure == null }
        printLine("interrupted with $finished of $all runs finished; the same command goes on with them")
        throw ProgramResult(EXIT_INTERRUPTED)
    }

    private fun interrupted(how: String): Nothing {
        printLine("interrupted at the end: $how")
        throw ProgramResult(EXIT_INTERRUPTED)
    }

    private fun requireEngine() {
        val name = engine ?: return
        if (name in allEngines.names) return
        throw InputException("--engine", null, "'$name' is no engine; ${adviceOn(name, allEngines)}")
    }

    private companion object {
        const val MOST_JOBS = 1000
        const val ONE_EACH = "each is for a command of its own"
    }
}
