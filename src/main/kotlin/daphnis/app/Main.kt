package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.IncorrectOptionValueCount
import com.github.ajalt.clikt.core.MissingOption
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.core.context
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.core.subcommands
import com.github.ajalt.clikt.core.terminal
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.versionOption
import com.github.ajalt.mordant.terminal.Terminal
import daphnis.app.live.joinedLive
import daphnis.app.printing.DEBUG
import daphnis.app.printing.flushPrinted
import daphnis.app.printing.showTrace
import daphnis.core.input.InputException
import daphnis.core.input.Nearest
import daphnis.core.run.Version
import kotlin.system.exitProcess

/** `daphnis`, the command line: see `daphnis --help` and docs/guide.md. */
class Daphnis : CliktCommand(name = "daphnis") {
    init {
        versionOption(Version.text)
        // Taken from among the words before they are parsed, since it may stand anywhere; here for the help.
        registerOption(option(DEBUG, help = "anywhere: show the stack trace of what goes wrong").flag())
    }

    override fun help(context: Context) =
        "Event-driven simulation of very many colliding spheres: planetary rings, granular flow, hard-sphere gases."

    override fun helpEpilog(context: Context) =
        "daphnis help COMMAND, or daphnis COMMAND --help, says what a command takes."

    override fun run() = Unit
}

fun main(args: Array<String>) {
    val output = StandardOutput.install()
    val code = runDaphnis(args)
    flushPrinted()
    val problem = output.problem ?: exitProcess(code)
    val failed = if (code == EXIT_DONE) EXIT_FAILED else code
    exitProcess(complain("standard output: $problem; part of the output was lost", failed))
}

/**
 * Exit codes: 0 done, 1 the simulation failed, 2 the input is wrong, 130 interrupted after a checkpoint. Whatever goes
 * wrong is one line on the error stream, and a stack trace only with [DEBUG].
 */
internal fun runDaphnis(args: Array<String>): Int {
    val words = joinedLive(args.filter { it != DEBUG }.toTypedArray())
    val command = daphnisCommand()
    return try {
        requireReadable(words)
        command.parse(command.pathsLast(command.understood(words)))
        EXIT_DONE
    } catch (e: ProgramResult) {
        e.statusCode
    } catch (e: UsageError) {
        complain(command.oneLine(e, words), EXIT_INPUT)
    } catch (e: CliktError) {
        command.echoFormattedHelp(e)
        if (e.statusCode == 0) EXIT_DONE else EXIT_INPUT
    } catch (e: Throwable) {
        if (DEBUG in args) showTrace(e)
        complain(e)
    }
}

/** The whole command line; to a mistyped word each command answers with one that may be meant, or with none. */
internal fun daphnisCommand(): Daphnis {
    val others = listOf(
        RunCommand(),
        ResumeCommand(),
        CompareCommand(),
        CiteCommand(),
        ReproduceCommand(),
        ExportCommand(),
        AnalyzeCommand(),
        MovieCommand(),
        ViewCommand(),
        ScenariosCommand(),
        DescribeCommand(),
        NodeCommand(),
        BenchCommand(),
        SweepCommand(),
        CompletionCommand(),
    )
    val commands = others + HelpCommand(others.map { it.commandName }.toSet())
    val daphnis = Daphnis().subcommands(commands)
    // The library hands these settings down to no command below.
    // Nothing is asked of the terminal where nobody says: that loads native code.
    val columns = columnsOf(System.getenv("COLUMNS"))?.let { outputColumns() }
    for (command in commands + daphnis) {
        command.context {
            // Of what is no terminal, such as a pager, the library takes no notice of the columns.
            if (columns != null) terminal = Terminal(width = columns)
            suggestTypoCorrection = { word, known -> listOfNotNull(Nearest.to(word, known)) }
            helpFormatter = { GroupedHelp.of(it, command.commandName) }
        }
    }
    return daphnis
}

/**
 * In a locale without their letters, words and the name of the working directory arrive as others, which would be taken
 * for what was meant.
 */
private fun requireReadable(words: Array<String>) {
    val encoding = System.getProperty("sun.jnu.encoding")
    val mend = "has letters that the locale's encoding, $encoding, has not; try LC_ALL=C.UTF-8"
    words.find { UNREADABLE in it }?.let { throw InputException("'$it'", null, mend) }
    val here = System.getProperty("user.dir")
    if (UNREADABLE in here) throw InputException("working directory", null, mend)
}

private const val UNREADABLE = '\uFFFD'

/** A first word that is no command goes alone, so that it is what the message is about. */
internal fun CliktCommand.understood(words: Array<String>): Array<String> {
    val first = words.firstOrNull() ?: return words
    return if (first.startsWith("-") || first in registeredSubcommandNames()) words else arrayOf(first)
}

/**
 * The library's message begins with the usage, and has colours on a terminal; a wrong word deserves one line and where
 * to read more.
 */
internal fun CliktCommand.oneLine(e: UsageError, words: Array<String>): String {
    val help = getFormattedHelp(e).orEmpty().replace(COLOUR, "")
    val errors = help.lines().filter { it.startsWith("Error: ") }.joinToString("; ") { it.removePrefix("Error: ") }
    // A word that its command does not know is told of by the one above.
    val here = e.context?.commandNameWithParents().orEmpty().ifEmpty { listOf("daphnis") }
    val below = words.take(1).filter { here.size == 1 && it in registeredSubcommandNames() }
    return "$errors${wanted(e)} (see ${(here + below).joinToString(" ")} --help)"
}

private val COLOUR = Regex("\u001B\\[[0-9;]*m")

/** What an option is for that is missing, or that has no value. */
private fun wanted(e: UsageError): String {
    if (e !is MissingOption && e !is IncorrectOptionValueCount) return ""
    val context = e.context ?: return ""
    val option = context.command.registeredOptions().find { e.paramName in it.names } ?: return ""
    val help = option.optionHelp(context)
    return if (help.isEmpty()) "" else ": $help"
}

internal const val EXIT_DONE = 0
internal const val EXIT_FAILED = 1
internal const val EXIT_INPUT = 2
internal const val EXIT_INTERRUPTED = 130
