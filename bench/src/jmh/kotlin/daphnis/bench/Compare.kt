package daphnis.bench

import daphnis.core.population.stateDigest
import java.util.Locale
import kotlin.system.exitProcess

/**
 * Engines in turn in one process, round after round, on the same steps: on a noisy machine the only fair comparison.
 * Prints the fastest round of each, in ms per step, and its speed relative to the serial engine.
 *
 * `java -cp bench/target/bench-0.2.0.jar daphnis.bench.CompareKt WORKLOAD STEPS ROUNDS`
 */
fun main(args: Array<String>) {
    val workload = Workload.entries.find { it.name == args.getOrNull(0) }
    val (steps, rounds) = listOf(1, 2).map { args.getOrNull(it)?.toIntOrNull()?.takeIf { n -> n > 0 } }
    if (workload == null || steps == null || rounds == null || args.size != 3) {
        System.err.println("compare: needs WORKLOAD STEPS ROUNDS; workloads are ${Workload.entries.joinToString()}")
        exitProcess(2)
    }
    val engines = listOf(EngineName.SERIAL to 1) + PARALLEL.flatMap { engine -> listOf(1, 2).map { engine to it } }
    val best = DoubleArray(engines.size) { Double.POSITIVE_INFINITY }
    val digests = HashSet<String>()
    val start = workload.Start()
    // The first round warms up.
    for (round in 0..rounds) {
        for ((k, engine) in engines.withIndex()) {
            start.simulation(engine.first.create(engine.second)).use { simulation ->
                simulation.advance()
                val begin = System.nanoTime()
                repeat(steps) { simulation.advance() }
                val milliseconds = (System.nanoTime() - begin) * 1e-6 / steps
                if (round > 0) best[k] = minOf(best[k], milliseconds)
                digests += stateDigest(simulation.population)
            }
        }
    }
    check(digests.size == 1) { "the engines disagree" }
    for ((k, engine) in engines.withIndex()) {
        val name = engine.first.name.lowercase().replace('_', '-')
        println(
            String.format(
                Locale.ROOT,
                "| %s | %s | %d | %.1f | %.2f × |",
                workload,
                name,
                engine.second,
                best[k],
                best[0] / best[k],
            ),
        )
    }
}

private val PARALLEL = listOf(
    EngineName.HORIZON,
    EngineName.ISLANDS,
    EngineName.THREAD_POOL,
    EngineName.ACTORS,
    EngineName.PEKKO,
)
