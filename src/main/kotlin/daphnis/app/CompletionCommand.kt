package daphnis.app

import com.github.ajalt.clikt.completion.CompletionGenerator
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.types.choice
import daphnis.app.printing.printLines

/** `daphnis completion`. */
class CompletionCommand : CliktCommand(name = "completion") {
    private val shell by argument("shell", help = "bash, zsh or fish").choice("bash", "zsh", "fish")

    override fun help(context: Context) = "Print a script with which a shell completes command lines of daphnis."

    override fun run() {
        val script = CompletionGenerator.generateCompletionForCommand(currentContext.findRoot().command, shell)
        printLines(if (shell == "fish") script else ofBash(script))
    }

    /** [script] with what the library's lacks: words as the shell takes them, names with blanks, settings. */
    private fun ofBash(script: String): String {
        val own = resource("completion.$shell")
        val settings = SettingWords.all.joinToString(" ") { "'$it'" }
        val parts = resource("completion.settings").replace("SETTINGS", settings)
        // Called in place, since what comes out of a process of its own is parted at blanks.
        val called = script.replace(CALL, "$1")
        check(REGISTRATION in called)
        return called.replaceFirst(REGISTRATION, "\n$parts\n$own".trimEnd())
    }

    private fun resource(name: String) =
        checkNotNull(CompletionCommand::class.java.getResource(name)) { "$name is missing" }.readText()

    private companion object {
        const val REGISTRATION = "\ncomplete -F _daphnis daphnis"
        val CALL = Regex("""COMPREPLY=\(\$\(compgen -F (\w+) 2>/dev/null\)\)""")
    }
}
