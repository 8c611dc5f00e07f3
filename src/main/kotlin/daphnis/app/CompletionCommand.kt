package daphnis.app

import com.github.ajalt.clikt.completion.CompletionGenerator
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.types.choice

/** `daphnis completion`. */
class CompletionCommand : CliktCommand(name = "completion") {
    private val shell by argument("shell", help = "bash, zsh or fish").choice("bash", "zsh", "fish")

    override fun help(context: Context) = "Print a script with which a shell completes command lines of daphnis."

    override fun run() {
        val script = CompletionGenerator.generateCompletionForCommand(currentContext.findRoot().command, shell)
        // A directory is completed with a slash, and blanks in names are quoted.
        printLines(script.replace("\ncomplete -F ", "\ncomplete -o filenames -F "))
    }
}
