package daphnis.bench

import java.util.Locale
import kotlin.system.exitProcess

/**
 * Where the project stands: one row for each ratio that it wants small or large, all measured in this process, in
 * turns, after a round that warms up.
 *
 * `java -Xmx8g -cp bench/target/bench-0.2.0.jar daphnis.bench.GoalsKt [size] [step] [threads] [actors] [memory]`
 *
 * Without names all of them. `rounds=N` (3) of which the fastest counts; `tiny` only shows that it works.
 */
fun main(args: Array<String>) {
    val tiny = "tiny" in args
    val rounds = args.firstOrNull { it.startsWith("rounds=") }?.removePrefix("rounds=")?.toIntOrNull()
        ?: if (tiny) 1 else ROUNDS
    val names = args.filterNot { it == "tiny" || it.startsWith("rounds=") }
    val unknown = names.filterNot { it in GOALS }
    if (unknown.isNotEmpty() || rounds < 1) {
        System.err.println(
            "goals: unknown: ${unknown.joinToString()}; known are ${GOALS.keys.joinToString()}, rounds=N >= 1, tiny",
        )
        exitProcess(2)
    }
    println("| goal | what | measured | |\n|---|---|--:|---|")
    val goals = Goals(if (tiny) Sizes.TINY else Sizes.FULL, rounds)
    for (name in names.ifEmpty { GOALS.keys }.distinct()) {
        for (row in GOALS.getValue(name)(goals)) {
            check(row.value.isFinite() && row.value > 0) { "$name: ${row.what}: ${row.value} is no measurement" }
            println("| $name | ${row.what} | ${"%.2f".format(Locale.ROOT, row.value)} | ${row.note} |")
        }
    }
}

private const val ROUNDS = 3

private val GOALS = linkedMapOf<String, (Goals) -> List<Row>>(
    "size" to Goals::size,
    "step" to Goals::step,
    "threads" to Goals::threads,
    "actors" to Goals::actors,
    "memory" to Goals::memory,
)

/** One line of the table. */
internal class Row(val what: String, val value: Double, val note: String)

/** How much work the goals are measured on; edges are those of ring patches. */
internal class Sizes(
    val smallRing: Int,
    val largeRing: Int,
    val smallGas: Int,
    val largeGas: Int,
    val gasOfSteps: Int,
    val dense: Int,
    val paperSteps: Int,
    val steps: Int,
    val secondsOfSteps: Double,
) {
    companion object {
        val FULL = Sizes(6, 19, 100_000, 1_000_000, 20_000, 100_000, 30, 10, 1.5)
        val TINY = Sizes(1, 2, 1000, 2000, 500, 500, 1, 2, 0.01)
    }
}

internal class Goals(private val sizes: Sizes, private val rounds: Int) {
    private fun timed(runners: List<Runner>): List<Runner> = runners.also { takeTurns(it, rounds) }

    /** A particle costs as much in a large system as in a small one. */
    fun size(): List<Row> {
        val rings = listOf(sizes.smallRing, sizes.largeRing).map { StartState(ring(it)) }
        val gases = listOf(sizes.smallGas, sizes.largeGas).map { StartState(gas(it, DILUTE, "random")) }
        return listOf(EngineName.SERIAL to 1, EngineName.HORIZON to 1, EngineName.ISLANDS to 2)
            .flatMap { (engine, threads) ->
                listOf("ring" to rings, "gas" to gases).map { (name, starts) ->
                    val dt = if (name == "ring") RING_STEP else GAS_STEP
                    val (small, large) = timed(starts.map { Runner(it, engine, threads, dt, sizes.steps) })
                    val what = "a particle-step of N = ${starts[1].size} over N = ${starts[0].size}"
                    val note = "${"%.0f, %.0f".format(
                        Locale.ROOT,
                        small.perParticle * 1e9,
                        large.perParticle * 1e9,
                    )} ns"
                    Row("${who(engine, threads)}, $name: $what", large.perParticle / small.perParticle, note)
                }
            }
    }

    /** How far ahead one searches is the engine's choice, so the step should not matter where no force acts. */
    fun step(): List<Row> = listOf(DILUTE, VERY_DILUTE, DENSE).flatMap { filling ->
        val isDense = filling == DENSE
        val gas = gas(sizes.gasOfSteps, filling, if (isDense) "lattice" else "random")
        val start = StartState(if (isDense) molten(gas) else gas)
        // The longest would take most engines hours in the dense gas.
        val runners = STEPS.filter { !isDense || it <= LONGEST_DENSE_STEP }.flatMap { dt ->
            // As many steps as cover the same time, within bounds: of short ones that would take all day.
            val steps = (sizes.secondsOfSteps / dt).toInt().coerceIn(1, MOST_STEPS)
            ENGINES.map { (engine, threads) -> Runner(start, engine, threads, dt, steps) }
        }
        timed(runners).groupBy { it.engine }.map { (engine, own) ->
            val counted = own.filter { it.collisions > 0 }
            val best = counted.minBy { it.perCollision }
            val worst = counted.maxBy { it.perCollision }
            val note = "%.1f us at dt = %s, %.1f us at dt = %s".format(
                Locale.ROOT,
                best.perCollision * 1e6,
                best.dt,
                worst.perCollision * 1e6,
                worst.dt,
            )
            val what = "a collision at the worst dt over the best, phi = $filling, N = ${start.size}"
            Row("${who(engine, own[0].threads)}: $what", worst.perCollision / best.perCollision, note)
        }
    }

    /** Two threads are twice as fast as one. */
    fun threads(): List<Row> = shared().flatMap { system ->
        val start = system.make()
        listOf(EngineName.HORIZON, EngineName.ISLANDS).map { engine ->
            val (one, two) = timed(listOf(1, 2).map { system.runner(start, engine, it) })
            val what = "two threads, times as fast as one"
            Row("${word(engine)}, ${system.name}: $what", one.perStep / two.perStep, note(one, two))
        }
    }

    /** Messages cost nothing. */
    fun actors(): List<Row> = shared().flatMap { system ->
        val start = system.make()
        val engines = listOf(EngineName.HORIZON, EngineName.ISLANDS, EngineName.ACTORS, EngineName.PEKKO)
        val all = timed(engines.map { system.runner(start, it, 2) })
        all.drop(1).map {
            val what = "time over that of horizon, two threads each"
            Row("${word(it.engine)}, ${system.name}: $what", it.perStep / all[0].perStep, note(all[0], it))
        }
    }

    /** One of the systems on which threads are compared, made when its turn comes. */
    private class Shared(val name: String, val dt: Double, val steps: Int, val make: () -> StartState) {
        fun runner(start: StartState, engine: EngineName, threads: Int) = Runner(start, engine, threads, dt, steps)
    }

    private fun shared() = listOf(0.1, 0.1, 0.3).mapIndexed { k, dt ->
        Shared("paper ${k + 1}", dt, sizes.paperSteps) { StartState(builtIn("paper-figure-${k + 1}")) }
    } + listOf(
        Shared("dense, phi = $DENSE", DENSE_STEP, sizes.steps) {
            StartState(molten(gas(sizes.dense, DENSE, "lattice")))
        },
        Shared("ring", RING_STEP, sizes.steps) { StartState(ring(sizes.smallRing)) },
    )

    /** What stays on the heap between steps, engine and population together. */
    fun memory(): List<Row> {
        val start = StartState(gas(sizes.largeGas, DILUTE, "random"))
        return ENGINES.map { (engine, threads) ->
            val before = liveBytes()
            val used = start.simulation(engine.create(threads), GAS_STEP).use { simulation ->
                repeat(STEPS_OF_MEMORY) { simulation.advance() }
                (liveBytes() - before).also { check(simulation.step > 0) }
            }
            Row("${who(engine, threads)}: bytes per sphere, N = ${start.size}", used.toDouble() / start.size, "B")
        }
    }

    private fun liveBytes(): Long {
        val runtime = Runtime.getRuntime()
        repeat(COLLECTIONS) { System.gc() }
        return runtime.totalMemory() - runtime.freeMemory()
    }

    private fun note(a: Runner, b: Runner) =
        "%.2f, %.2f ms per step".format(Locale.ROOT, a.perStep * 1e3, b.perStep * 1e3)

    private fun who(engine: EngineName, threads: Int) = word(engine) + if (threads == 1) "" else " on $threads threads"

    private fun word(engine: EngineName) = engine.name.lowercase().replace('_', '-')

    private companion object {
        const val DILUTE = 0.1
        const val VERY_DILUTE = 0.01
        const val DENSE = 0.45
        const val GAS_STEP = 0.1
        const val DENSE_STEP = 0.03
        const val LONGEST_DENSE_STEP = 0.3
        const val MOST_STEPS = 60
        const val STEPS_OF_MEMORY = 5
        const val COLLECTIONS = 3

        /** In units of the time in which a sphere moves its diameter. */
        val STEPS = listOf(0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0)
        val ENGINES = listOf(EngineName.SERIAL to 1, EngineName.HORIZON to 1) +
            listOf(EngineName.ISLANDS, EngineName.THREAD_POOL, EngineName.ACTORS, EngineName.PEKKO)
                .map { it to 2 }
    }
}
