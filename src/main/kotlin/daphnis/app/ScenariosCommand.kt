package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.optional
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import daphnis.app.describe.Rows
import daphnis.app.printing.printLines
import daphnis.core.input.InputException
import daphnis.core.input.Nearest
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSchema

/** `daphnis scenarios`. */
class ScenariosCommand : CliktCommand(name = "scenarios") {
    private val wanted by argument(
        "name",
        help = "built-in scenario to print, to start your own from",
        completionCandidates = Candidates.builtIn,
    ).optional()

    private val schema by option("--schema", help = "print the JSON Schema of scenarios, for editors").flag()

    override fun help(context: Context) = "List the built-in scenarios, or print one."

    override fun run() {
        val name = wanted
        if (schema) {
            if (name != null) throw InputException("--schema", null, "is of all scenarios; leave out $name")
            printLines(ScenarioSchema.text().trimEnd())
        } else if (name == null) {
            val rows = Rows(BuiltIn.names.maxOf { it.length } + 2)
            for (known in BuiltIn.names) rows.add(known, BuiltIn.scenario(known).description)
            printLines(rows.text(outputColumns() ?: Int.MAX_VALUE))
        } else {
            val text = BuiltIn.text(name) ?: throw unknown(name)
            val named = "{\n  \"${ScenarioSchema.KEY}\": \"${ScenarioSchema.ADDRESS}\","
            printLines(text.trimEnd().replaceFirst(Regex("(?m)^\\{"), Regex.escapeReplacement(named)))
        }
    }

    private fun unknown(name: String): InputException {
        val known = BuiltIn.names
        return InputException(
            name,
            null,
            "no built-in scenario; ${Nearest.question(name, known)}known: ${known.joinToString()}",
        )
    }
}
