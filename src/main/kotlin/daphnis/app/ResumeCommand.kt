package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import daphnis.app.live.LiveOption
import daphnis.core.input.InputException
import daphnis.core.run.Run

/** `daphnis resume`. */
class ResumeCommand : CliktCommand(name = "resume") {
    private val directory by argument("dir", help = "run directory", completionCandidates = Candidates.files)
    private val until by option(
        "--until",
        help = "end at this time instead of the scenario's, in its unit of time",
    ).double()
    private val acceptLoss by option(
        "--accept-loss",
        help = "continue with damaged tables as they are, and report what is lost",
    ).flag()
    private val quiet by option("--quiet", help = "no progress").flag()
    private val threads by threadsOption("threads of each node on this machine, with --nodes")
    private val live by LiveOption()
    private val fleet by FleetOptions()

    override fun help(context: Context) =
        "Continue a run from its last good checkpoint, to the same bits as an uninterrupted run."

    override fun run() {
        if (threads != null &&
            !fleet.isGiven
        ) {
            throw InputException(
                "--threads",
                null,
                "needs --nodes; without nodes edit engine.threads in the run's scenario.json",
            )
        }
        val path = pathOf(directory, "dir")
        live.withPage { page ->
            fleet.withEngines(path.fileName?.toString() ?: "run", threads) { engines ->
                carryOut(quiet, page, fleet) { Run.resume(path, until, engines, acceptLoss) }
            }
        }
    }
}
