package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import daphnis.app.cite.RunCitation
import daphnis.app.printing.printLine
import daphnis.core.input.InputException
import daphnis.core.run.Run
import daphnis.core.run.RunDirectory
import daphnis.core.run.Summary
import daphnis.core.run.Version
import daphnis.core.scenario.Scenario
import java.nio.file.Files
import java.nio.file.Path

/** `daphnis reproduce`: exit code 0 when a run that is done again ends in the same state, 1 when it does not. */
class ReproduceCommand : CliktCommand(name = "reproduce") {
    private val source by argument(
        "record",
        help = "what `daphnis cite --record` wrote, or a run directory",
        completionCandidates = Candidates.files,
    )
    private val engine by option(
        "--engine",
        help = "collision engine: ${allEngines.names.joinToString()}",
        completionCandidates = Candidates.engine,
    )
    private val threads by threadsOption("threads of the engine (default: one per core)")
    private val out by option(
        "--out",
        metavar = "dir",
        help = "run directory (default: runs/NAME, numbered when it exists)",
        completionCandidates = Candidates.files,
    )
    private val quiet by option("--quiet", help = "no progress").flag()

    override fun help(context: Context) = "Do a run again and say whether it ends in the same state."

    override fun run() {
        val path = pathOf(source, "record")
        val settings = listOfNotNull(engine?.let { "engine.name=$it" }, "engine.threads=${threads ?: 0}")
        val was: End
        val scenario: Scenario
        if (Files.isDirectory(path)) {
            val recorded = Run.open(path)
            RunCitation.scenarioOf(recorded)
            was = RunCitation.finished(recorded).let { End(it.stateDigest, it.steps, it.version) }
            scenario = scenarioNamed("${recorded.directory.scenario}", settings)
        } else {
            val citation = RunCitation.read(path)
            was = End(citation.stateDigest, citation.steps, citation.daphnis)
            scenario = citation.scenario(source, settings)
        }
        val directory =
            out?.let { free(pathOf(it, "--out")) }
                ?: freeDirectory(Path.of("runs").resolve(directoryName(scenario.name)))
        carryOut(quiet) { Run.start(scenario, source, directory, force = false, allEngines) }
        compare(was, Summary.read(RunDirectory(directory).summary))
    }

    /** Nothing is replaced: what is done again is something else than what is there. */
    private fun free(directory: Path): Path {
        val there = RunDirectory(directory)
        if (Files.exists(there.scenario) || Files.exists(there.program)) {
            throw InputException("--out", null, "$directory holds a run already; give another directory")
        }
        return directory
    }

    private class End(val digest: String, val steps: Long, val version: String)

    private fun compare(was: End, summary: Summary) {
        if (was.digest == summary.stateDigest && was.steps == summary.steps) {
            printLine("reproduced: the digest is that of the run with daphnis ${was.version}")
            return
        }
        val versions = if (was.version == Version.text) "" else " (daphnis ${was.version}, here ${Version.text})"
        printLine("not reproduced: the run ended after step ${was.steps} with state digest ${was.digest}$versions")
        throw ProgramResult(EXIT_FAILED)
    }
}
