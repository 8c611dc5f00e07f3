package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.optional
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.long
import daphnis.app.live.LiveOption
import daphnis.app.progress.TimesInWords
import daphnis.core.input.InputException
import daphnis.core.run.ProgramRecord
import daphnis.core.run.Run
import daphnis.core.run.RunOrigin
import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.TimeStepSpec
import java.nio.file.Files
import java.nio.file.Path

/** `daphnis run`. */
class RunCommand : CliktCommand(name = "run") {
    private val scenario by argument(
        help = "scenario file or built-in name (default: paper-figure-1, or with --from the scenario of that run)",
        completionCandidates = Candidates.scenario,
    ).optional()
    private val from by option(
        FROM,
        metavar = "run@state",
        help = "start from a state of another run: RUN (its last), RUN@STEP, RUN@time=T or RUN@orbits=T",
        completionCandidates = Candidates.files,
    )
    private val engine by option(
        "--engine",
        help = "collision engine: ${allEngines.names.joinToString()}",
        completionCandidates = Candidates.engine,
    )
    private val threads by threadsOption("threads of the engine (default: one per core)")
    private val steps by option("--steps", help = "end after this many steps").long()
    private val until by option("--until", help = "end at this time, in the scenario's unit of time").double()
    private val seed by option("--seed", help = "seed of the initial state").long()
    private val settings by option(
        "--set",
        metavar = "path=value",
        help = "replace any key of the scenario, such as timeStep.dt=0.05 or 'forces[0].x=-167'; " +
            "'forces[+]={…}' adds an entry",
        completionCandidates = Candidates.setting,
    ).multiple()
    private val out by option(
        "--out",
        metavar = "dir",
        help = "run directory (default: runs/NAME, numbered when it exists)",
        completionCandidates = Candidates.files,
    )
    private val force by option("--force", help = "replace the run in the run directory").flag()
    private val quiet by option("--quiet", help = "no progress").flag()
    private val live by LiveOption()
    private val fleet by FleetOptions()

    override fun help(context: Context) = "Simulate a scenario into a run directory."

    override fun run() {
        if (engine != null && fleet.isGiven) {
            throw InputException("--engine", null, "is for one process; nodes compute in a way of their own")
        }
        val origin = from?.let(::originNamed)?.also(::checkState)
        val source = scenario ?: origin?.let { ownScenario(it) } ?: "paper-figure-1"
        val changes = settings + listOfNotNull(
            from?.let { "from $it" },
            until?.let { "until=$it" },
            steps?.let { "steps=$it" },
            seed?.let { "seed=$it" },
        )
        val changed = scenarioNamed(source, settings + shorthands()).changedBy(changes)
        val resolved = resolve(changed, source, origin)
        val directory =
            out?.let { pathOf(it, "--out") } ?: freeDirectory(Path.of("runs").resolve(directoryName(resolved.name)))
        live.withPage { page ->
            fleet.withEngines(resolved.name, threads) { engines ->
                carryOut(quiet, page, fleet) {
                    Run.start(resolved, source, directory, force, engines, from = origin)
                }
            }
        }
    }

    /** What makes an initial state has no meaning when that is of another run. */
    private fun checkState(origin: RunOrigin) {
        if (seed != null) throw InputException("--seed", null, "is of an initial state; with $FROM it is $from")
        for (setting in settings) {
            if (!origin.isOfState(setting.substringBefore('='))) continue
            throw InputException("--set", setting, "is of an initial state; with $FROM it is $from")
        }
    }

    /** The scenario of the run from which this one starts. */
    private fun ownScenario(origin: RunOrigin): String {
        val directory = origin.run.directory
        if (!Files.exists(directory.scenario)) {
            val whose = "is of ${ProgramRecord.read(directory.program)}"
            throw InputException(origin.name, null, "$whose, which has no scenario; give one for the new run")
        }
        return "${directory.scenario}"
    }

    private fun shorthands() = listOfNotNull(
        engine?.let { "engine.name=$it" },
        threads?.takeUnless { fleet.isGiven }?.let { "engine.threads=$it" },
        until?.let { "until=$it" },
        seed?.let { "seed=$it" },
    )

    private fun resolve(scenario: Scenario, source: String, origin: RunOrigin?): Scenario {
        val steps = steps ?: return scenario.also { checkEnd(it, source, origin) }
        if (until != null) {
            throw InputException("--steps", null, "is given together with --until; one of the two is enough")
        }
        if (steps < 1) throw InputException("--steps", null, "is $steps; it must be at least 1")
        val step = FrameSetup.times(scenario.copy(until = 1.0), source).timeStep.dt
            ?: throw InputException("--steps", null, "needs a fixed time step; use --until")
        return scenario.copy(until = (origin?.state?.time ?: scenario.startTime) + steps * step)
    }

    /** A state of the end of a run, which is the usual one, leaves nothing to do. */
    private fun checkEnd(scenario: Scenario, source: String, origin: RunOrigin?) {
        val start = origin?.state?.time ?: return
        if (until != null) return
        val end = FrameSetup.times(scenario, source).end
        if (end > start) return
        val times = TimesInWords.of(scenario)
        val ends = "and the run would end at ${times.text(end)}"
        throw InputException(FROM, null, "is at time ${times.text(start)}, $ends; give --steps or --until")
    }
}
