package daphnis.analysis.report

import daphnis.analysis.brightness.ScatteringLaw
import daphnis.analysis.occultation.Footprint
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import java.nio.file.Files
import java.nio.file.Path
import kotlin.system.exitProcess

/**
 * `tools/error-bars/error-bars SCENARIO SEEDS DIRECTORY [path=value...]`: prints how often ± cover the mean over the
 * seeds 1 to SEEDS, and in how many of the runs a drift that is added is found. With the property `daphnis.footprint`,
 * such as 20x10, those of the light through the patch, too, and with `daphnis.brightness` those of the light that
 * Lambert spheres scatter, in so many orders.
 */
fun main(args: Array<String>) {
    val seeds = args.getOrNull(1)?.toIntOrNull() ?: 0
    if (args.size < 3 || seeds < 2) {
        System.err.println("usage: tools/error-bars/error-bars SCENARIO SEEDS DIRECTORY [path=value...]")
        exitProcess(2)
    }
    val scenario = scenario(args[0], args.drop(3))
    val bars = ErrorBars(AnalysisOptions(occultation = light(), brightness = brightness()))
    for (seed in 1L..seeds) bars.add(scenario, seed, Path.of(args[2]).resolve("$seed"))
    print(bars.table())
    println()
    print(bars.driftTable())
    println("\n${bars.runs} runs, ${bars.unsteady} of them with numbers without ± since they are called not steady")
}

/** A grid of directions, and scans of the footprint that is asked for. */
private fun light(): OccultationOptions {
    val sizes =
        System.getProperty("daphnis.footprint")?.split('x')?.map { it.toDouble() } ?: return OccultationOptions()
    val elevations = doubleArrayOf(10.0, 20.0, 40.0, 60.0, 90.0)
    return OccultationOptions(elevations, footprint = Footprint.rectangle(sizes[0], sizes[1]), photons = 1000.0)
}

private fun brightness(): BrightnessOptions? = System.getProperty("daphnis.brightness")?.let {
    BrightnessOptions(ScatteringLaw.lambert(1.0), orders = it.toInt(), paths = FEW_PATHS)
}

/** So that their noise is seen. */
private const val FEW_PATHS = 256

private fun scenario(name: String, settings: List<String>): Scenario {
    val path = Path.of(name)
    return if (Files.exists(path)) ScenarioJson.read(path, settings) else BuiltIn.scenario(name, settings)
}
