package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import daphnis.core.FixedTimeStep
import daphnis.core.run.engineOf
import daphnis.core.scenario.BoundarySpec
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
        if (scenario.boundary !is BoundarySpec.Open &&
            scenario.boundary !is BoundarySpec.HillSheet
        ) {
            row("filling factor", "%.6g", fillingFactor(radii, setup.boundary.box))
        }
        row("box", "%s, %s", scenario.box.lengths.joinToString(" x "), scenario.boundary.javaClass.simpleName)
        val omega = setup.angularSpeed ?: return
        row("frame", "angular speed %.6g, orbit %.6g", omega, 2 * Math.PI / omega)
        val area = setup.boundary.box.length(0) * setup.boundary.box.length(1)
        val particles = radii.indices.filter { setup.population.id[it] < (setup.scenario.firstBody ?: Int.MAX_VALUE) }
        row("optical depth", "%.6g", particles.sumOf { Math.PI * radii[it] * radii[it] } / area)
        row("surface density", "%.6g", particles.sumOf { setup.population.mass[it] } / area)
    }

    private fun describeStep(setup: ScenarioSetup, scenario: Scenario) {
        val dt = setup.timeStep.next(setup.population)
        val steps = if (setup.timeStep is FixedTimeStep) {
            "%.0f".format(Locale.ROOT, ceil((setup.scenario.end - setup.scenario.startTime) / dt - 1e-6))
        } else {
            "at least %.0f".format(
                Locale.ROOT,
                (setup.scenario.end - setup.scenario.startTime) / dt,
            )
        }
        row("steps", "%s of %.6g to time %.6g", steps, dt, setup.scenario.end)
        val reach = Reach().apply { measure(setup.population, dt) }
        row("reach in a step", "%.4g x %.4g x %.4g", reach.bound[0], reach.bound[1], reach.bound[2])
        val grid = Grid().apply { build(setup.population, setup.boundary, 0.0, dt, reach.bound, structure = setup.scenario.search) }
        for (size in 0 until grid.classes) {
            val radii = if (grid.classes > 1) ", for radii up to %.4g".format(Locale.ROOT, grid.largestRadius(size)) else ""
            val cells = (0..2).joinToString(" x ") { "${grid.cellsAlong(it, size)}" }
            val widths = (0..2).joinToString(" x ") { "%.4g".format(Locale.ROOT, grid.cellWidth(it, size)) }
            row(if (size == 0) "cells" else "", "%s, each %s%s", cells, widths, radii)
        }
    }

    private fun row(label: String, format: String, vararg values: Any) {
        println(label.padEnd(LABEL) + if (values.isEmpty()) format else String.format(Locale.ROOT, format, *values))
    }

    private companion object {
        const val LABEL = 18
    }
}
