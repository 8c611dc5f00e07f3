package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import daphnis.app.describe.CostRows
import daphnis.app.describe.GravityRows
import daphnis.app.describe.PhysicsRows
import daphnis.app.describe.Rows
import daphnis.app.printing.printLines
import daphnis.core.input.Quantities
import daphnis.core.run.engineOf
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.scenario.warnings

/**
 * `daphnis describe`: makes the initial state and says what it amounts to; does not run. The physics comes first, with
 * units, for that is where mistakes are.
 */
class DescribeCommand : CliktCommand(name = "describe") {
    private val word by argument(
        "scenario",
        help = "scenario file or built-in name",
        completionCandidates = Candidates.scenario,
    )
    private val settings by option(
        "--set",
        metavar = "path=value",
        help = "replace any key of the scenario",
        completionCandidates = Candidates.setting,
    ).multiple()

    override fun help(context: Context) = "Say what a scenario means in numbers, or what is wrong with it."

    override fun run() {
        val scenario = scenarioNamed(word, settings)
        val setup = ScenarioSetup.of(scenario, word)
        engineOf(scenario, word, allEngines).close()
        val rows = Rows()
        rows.add("scenario", scenario.name)
        if (scenario.description.isNotEmpty()) scenario.description.lines().forEach { rows.add("", it) }
        val say = Quantities(setup.scenario.units, setup.scenario.cmPerSecond)
        PhysicsRows(setup, say, rows).write()
        GravityRows(setup, say, rows).write()
        CostRows(setup, say, rows).write()
        for (notice in setup.notices + warnings(setup)) rows.add("note", notice)
        printLines(rows.text(outputColumns() ?: Int.MAX_VALUE))
    }
}
