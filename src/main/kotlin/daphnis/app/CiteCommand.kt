package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.option
import daphnis.app.cite.RunCitation
import daphnis.app.printing.printLine
import daphnis.app.printing.printLines
import daphnis.core.input.InputException
import daphnis.core.run.Run
import daphnis.core.run.Version
import java.nio.file.Files
import java.nio.file.LinkOption

/** `daphnis cite`: what a paper says of a run. */
class CiteCommand : CliktCommand(name = "cite") {
    private val run by argument("run", help = "run directory", completionCandidates = Candidates.files)
    private val record by option(
        "--record",
        metavar = "file",
        help = "write a file with which anyone can do the run again: daphnis reproduce FILE",
        completionCandidates = Candidates.files,
    )

    override fun help(context: Context) = "Print how to cite a run: scenario, version, digest, BibTeX."

    override fun run() {
        val recorded = Run.open(pathOf(run, "run"))
        val scenario = RunCitation.scenarioOf(recorded)
        val summary = RunCitation.finished(recorded)
        record?.let { newFileOf(it, "--record") }?.let { path ->
            if (Files.exists(path, LinkOption.NOFOLLOW_LINKS)) {
                throw InputException("--record", null, "$path is there already; give another name, or remove it")
            }
            val citation = RunCitation.of(recorded)
            writing(path.toAbsolutePath().parent) { citation.write(path) }
        }
        printLine("scenario      ${scenario.name}")
        if (scenario.description.isNotEmpty()) printLine("              ${scenario.description}")
        printLine("version       daphnis ${summary.version}")
        printLine("end           step ${summary.steps}, time ${summary.time} in the scenario's unit of time")
        printLine("state digest  ${summary.stateDigest}")
        record?.let { printLine("again         ${Version.command} reproduce $it") }
        printLine("")
        printLines(bibtex(summary.version))
    }

    private fun bibtex(version: String) = """
        @software{daphnis,
          author  = {{The developers of daphnis}},
          title   = {daphnis: event-driven simulation of very many colliding spheres},
          version = {$version},
          url     = {https://github.com/daphnis-sim/daphnis}
        }
    """.trimIndent()
}
