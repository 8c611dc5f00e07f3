package daphnis.analysis.report

import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import java.nio.file.Files
import java.nio.file.Path
import kotlin.system.exitProcess

/**
 * `tools/error-bars/error-bars SCENARIO SEEDS DIRECTORY [path=value...]`: prints how often ± cover the mean over the
 * seeds 1 to SEEDS, and in how many of the runs a drift that is added is found.
 */
fun main(args: Array<String>) {
    val seeds = args.getOrNull(1)?.toIntOrNull() ?: 0
    if (args.size < 3 || seeds < 2) {
        System.err.println("usage: tools/error-bars/error-bars SCENARIO SEEDS DIRECTORY [path=value...]")
        exitProcess(2)
    }
    val scenario = scenario(args[0], args.drop(3))
    val bars = ErrorBars()
    for (seed in 1L..seeds) bars.add(scenario, seed, Path.of(args[2]).resolve("$seed"))
    print(bars.table())
    println()
    print(bars.driftTable())
    println("\n${bars.runs} runs, ${bars.unsteady} of them with numbers without ± since they are called not steady")
}

private fun scenario(name: String, settings: List<String>): Scenario {
    val path = Path.of(name)
    return if (Files.exists(path)) ScenarioJson.read(path, settings) else BuiltIn.scenario(name, settings)
}
