package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import daphnis.core.FixedTimeStep
import daphnis.core.boundary.Open
import daphnis.core.run.engineOf
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.search.Grid
import daphnis.core.search.Reach
import daphnis.core.setup.fillingFactor
import java.util.Locale
import kotlin.math.ceil

/** `daphnis describe`: makes the initial state and says what it amounts to; does not run. */
class DescribeCommand : CliktCommand(name = "describe") {
    private val word by argument("scenario", help = "scenario file or built-in name")
    private val settings by option("--set", metavar = "path=value", help = "replace any key of the scenario").multiple()

    override fun help(context: Context) = "Say what a scenario means in numbers, or what is wrong with it."

    override fun run() {
        val scenario = scenarioNamed(word, settings)
        engineOf(scenario, word, allEngines).close()
        val setup = ScenarioSetup.of(scenario, word)
        row("scenario", scenario.name)
        if (scenario.description.isNotEmpty()) row("", scenario.description)
        describeParticles(setup, scenario)
        describeStep(setup, scenario)
        row("memory", "%.0f MiB", setup.population.size * ScenarioSetup.BYTES_PER_SPHERE / (1 shl 20))
    }

    private fun describeParticles(setup: ScenarioSetup, scenario: Scenario) {
        val radii = setup.population.radius
        row("particles", "%d", radii.size)
        row("radius", "%.6g to %.6g", radii.min(), radii.max())
        if (setup.boundary !== Open) row("filling factor", "%.6g", fillingFactor(radii, setup.boundary.box))
        row("box", "%s, %s", scenario.box.lengths.joinToString(" x "), setup.boundary.javaClass.simpleName)
    }

    private fun describeStep(setup: ScenarioSetup, scenario: Scenario) {
        val dt = setup.timeStep.next(setup.population)
        val steps = if (setup.timeStep is FixedTimeStep) {
            "%.0f".format(Locale.ROOT, ceil(setup.scenario.end / dt - 1e-6))
        } else {
            "at least %.0f".format(
                Locale.ROOT,
                setup.scenario.end / dt,
            )
        }
        row("steps", "%s of %.6g to time %.6g", steps, dt, setup.scenario.end)
        val reach = Reach().apply { measure(setup.population, dt) }
        row("reach in a step", "%.4g x %.4g x %.4g", reach.bound[0], reach.bound[1], reach.bound[2])
        val grid = Grid().apply { build(setup.population, setup.boundary, 0.0, dt, reach.bound) }
        row(
            "cells",
            "%d x %d x %d, each %.4g x %.4g x %.4g",
            grid.cellsAlong(0),
            grid.cellsAlong(1),
            grid.cellsAlong(2),
            grid.cellWidth(0),
            grid.cellWidth(1),
            grid.cellWidth(2),
        )
    }

    private fun row(label: String, format: String, vararg values: Any) {
        println(label.padEnd(LABEL) + if (values.isEmpty()) format else String.format(Locale.ROOT, format, *values))
    }

    private companion object {
        const val LABEL = 18
    }
}
