package daphnis.app

import com.github.ajalt.clikt.completion.CompletionCandidates
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.optional

/** `daphnis help run` means `daphnis run --help`, and `daphnis help` means `daphnis --help`. */
class HelpCommand(commands: Set<String>) : CliktCommand(name = "help") {
    private val about by argument(
        "command",
        help = "what to say more about",
        completionCandidates = CompletionCandidates.Fixed(commands),
    ).optional()

    override fun help(context: Context) = "Say what a command takes, or which commands there are."

    override fun run() {
        val daphnis = currentContext.findRoot().command as Daphnis
        daphnis.parse(daphnis.understood(listOfNotNull(about, "--help").toTypedArray()))
    }
}
