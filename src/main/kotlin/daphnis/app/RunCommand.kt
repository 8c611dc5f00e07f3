package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.default
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.long
import daphnis.core.run.Run
import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.InputException
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.TimeStepSpec
import java.nio.file.InvalidPathException
import java.nio.file.Path

/** `daphnis run`. */
class RunCommand : CliktCommand(name = "run") {
    private val scenario by argument(
        help = "scenario file or built-in name (default: paper-figure-1)",
    ).default("paper-figure-1")
    private val engine by option("--engine", help = "collision engine: ${allEngines.names.joinToString()}")
    private val threads by threadsOption("threads of the engine (default: one per core)")
    private val steps by option("--steps", help = "end after this many steps").long()
    private val until by option("--until", help = "end at this time").double()
    private val seed by option("--seed", help = "seed of the initial state").long()
    private val settings by option(
        "--set",
        metavar = "path=value",
        help = "replace any key of the scenario, such as timeStep.dt=0.05 or 'forces[0].x=-167'",
    ).multiple()
    private val out by option(
        "--out",
        metavar = "dir",
        help = "run directory (default: runs/NAME, numbered when it exists)",
    )
    private val force by option("--force", help = "replace the run in the run directory").flag()
    private val quiet by option("--quiet", help = "no progress").flag()
    private val fleet by FleetOptions()

    override fun help(context: Context) = "Simulate a scenario into a run directory."

    override fun run() {
        if (engine != null && fleet.isGiven) {
            throw InputException("--engine", null, "is for one process; nodes compute in a way of their own")
        }
        val resolved = resolve(described(scenarioNamed(scenario, settings + shorthands())))
        val directory = out?.let { pathOf(it, "--out") } ?: directoryNamed(resolved.name)
        fleet.withEngines(resolved.name, threads) { engines ->
            carryOut(quiet) { Run.start(resolved, scenario, directory, force, engines) }
        }
    }

    private fun shorthands() = listOfNotNull(
        engine?.let { "engine.name=$it" },
        threads?.takeUnless { fleet.isGiven }?.let { "engine.threads=$it" },
        until?.let { "until=$it" },
        seed?.let { "seed=$it" },
    )

    /** What the command line changes of the physics is said behind the description, which may no longer hold. */
    private fun described(scenario: Scenario): Scenario {
        val changes = settings.filterNot { it.startsWith("output.") || it.startsWith("engine.") } +
            listOfNotNull(until?.let { "until=$it" }, steps?.let { "steps=$it" }, seed?.let { "seed=$it" })
        val isOwn = settings.any { it.startsWith("description=") }
        if (scenario.description.isEmpty() || changes.isEmpty() || isOwn) return scenario
        return scenario.copy(description = "${scenario.description}; changed: ${changes.joinToString(", ")}")
    }

    private fun resolve(scenario: Scenario): Scenario {
        val steps = steps ?: return scenario
        if (until != null) {
            throw InputException("--steps", null, "is given together with --until; one of the two is enough")
        }
        if (steps < 1) throw InputException("--steps", null, "is $steps; it must be >= 1")
        val step = FrameSetup.times(scenario.copy(until = 1.0), this.scenario).timeStep as? TimeStepSpec.Fixed
            ?: throw InputException("--steps", null, "needs a fixed time step; use --until")
        return scenario.copy(until = scenario.startTime + steps * step.dt)
    }

    /** runs/NAME, or runs/NAME-2, -3, … */
    private fun directoryNamed(name: String): Path {
        val letters = name.map { if (isNameable(it)) it else '-' }.joinToString("")
        val safe = letters.trim('.').take(LONGEST_NAME).ifEmpty { "run" }
        return freeDirectory(Path.of("runs").resolve(safe))
    }

    /** Letters beyond ASCII only where the file system takes them, which depends on the locale. */
    private fun isNameable(c: Char): Boolean = try {
        c in "-_." || (c.isLetterOrDigit() && Path.of("$c").toString() == "$c")
    } catch (e: InvalidPathException) {
        false
    }

    private companion object {
        const val LONGEST_NAME = 80
    }
}
