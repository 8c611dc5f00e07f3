package daphnis.drills

import daphnis.app.allEngines
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.population.stateDigest
import java.lang.management.ManagementFactory
import java.util.Locale

/**
 * How much longer steps take in each engine than in the serial one, where engines are made as users get them. What is
 * lost is a digest that differs, never a time: times are told in the notes, for a reader to judge.
 */
internal object CliffDrill : Drill {
    override val name = "cliff"
    override val what = "steps of drawn systems timed in every engine: the worst ten over the serial one, and digests"
    override val cases = 2000

    /** How often as long as with the serial engine [engine] has taken. */
    private class Ratio(val engine: String, val value: Double, val case: CliffCase)

    override fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally {
        val lost = ArrayList<String>()
        val ratios = ArrayList<Ratio>()
        for (drawn in seed until seed + cases) {
            val case = CliffCase(drawn)
            val before = ratios.size
            val serial = Timing(case, SerialEngine(), case.steps, CliffCase.MOST_SECONDS)
            for (engine in engines) {
                val ratio = ratio(case, engine, serial, lost) ?: continue
                ratios += Ratio(engine, ratio, case)
            }
            val told = ratios.subList(before, ratios.size).joinToString { "${it.engine} ${"%.2f".format(it.value)}" }
            say("$case: $told")
        }
        return Tally(cases, lost, worst(ratios) + engines.map { spread(it, ratios) })
    }

    /** The least of some attempts where the first looks bad: others may have been at work, or the JVM's compiler. */
    private fun ratio(case: CliffCase, engine: String, first: Timing, lost: MutableList<String>): Double? {
        var serial = first
        var least = Double.POSITIVE_INFINITY
        for (attempt in 1..ATTEMPTS) {
            if (attempt > 1) serial = Timing(case, SerialEngine(), case.steps, CliffCase.MOST_SECONDS)
            val other =
                Timing(case, case.engine(engine) { allEngines.create(engine, case.threads)!! }, serial.begun, FOREVER)
            if (serial.end != other.end) lost += "$case: $engine ends with ${other.end}, serial with ${serial.end}"
            if (serial.end != other.end || serial.steps == 0) return null
            val begun = other.first / (serial.first + START)
            least = minOf(least, if (serial.steps == 1) begun else maxOf(begun, other.later / serial.later))
            if (least < SUSPECT) break
        }
        return least
    }

    /**
     * At most [most] steps of [case] on [engine], which may begin in the first [mostSeconds], and what they came to: a
     * digest, or what was thrown.
     */
    private class Timing(case: CliffCase, engine: CollisionEngine, most: Int, mostSeconds: Double) {
        /** Of the first step, in which threads start, and of all others together. */
        var first = Double.NaN
            private set
        var later = 0.0
            private set

        /** How many were begun, and done. */
        var begun = 0
            private set
        var steps = 0
            private set
        val end: String

        init {
            end = case.simulation(engine).use { simulation ->
                try {
                    while (begun < most && later < mostSeconds) {
                        begun++
                        val seconds = seconds { simulation.advance() }
                        if (steps++ == 0) first = seconds else later += seconds + FLOOR
                    }
                    stateDigest(simulation.population)
                } catch (e: RuntimeException) {
                    "${e.javaClass.name}: ${e.message}"
                }
            }
        }
    }

    /**
     * How long [work] takes: the time that has gone by, or that of all threads together where that is less, as on a
     * machine that is busy with something else.
     */
    private inline fun seconds(work: () -> Unit): Double {
        val busy = busyNanos()
        val begin = System.nanoTime()
        work()
        val passed = System.nanoTime() - begin
        val busyTime = busyNanos() - busy
        // A thread that has ended takes its time with it.
        return (if (busyTime > 0) minOf(passed, busyTime) else passed) / NANOS
    }

    private fun busyNanos(): Long {
        val threads = ManagementFactory.getThreadMXBean()
        return threads.allThreadIds.sumOf { maxOf(0, threads.getThreadCpuTime(it)) }
    }

    private fun worst(ratios: List<Ratio>): List<String> =
        ratios.sortedByDescending { it.value }.take(WORST).map { "%.1f × in %s, %s".root(it.value, it.engine, it.case) }

    private fun spread(engine: String, ratios: List<Ratio>): String {
        val sorted = ratios.filter { it.engine == engine }.map { it.value }.sorted()
        if (sorted.isEmpty()) return "$engine: nothing was timed"
        fun part(p: Double) = sorted[(p * (sorted.size - 1)).toInt()]
        return "%s: half of the cases up to %.2f ×, 90 %% %.2f, 99 %% %.2f, all %.2f; %d over %.0f"
            .root(engine, part(0.5), part(0.9), part(0.99), sorted.last(), sorted.count { it > AIM }, AIM)
    }

    private fun String.root(vararg words: Any) = format(Locale.ROOT, *words)

    private val engines = allEngines.names.filter { it != "serial" }

    private const val WORST = 10
    private const val AIM = 5.0

    /** A ratio from which on it is timed again, and how often at most. */
    private const val SUSPECT = 3.0
    private const val ATTEMPTS = 3
    private const val NANOS = 1e9
    private const val FOREVER = Double.POSITIVE_INFINITY

    /** Seconds that a step may take anyway, and a first one, in which threads and an actor system start. */
    private const val FLOOR = 1e-4
    private const val START = 0.1
}
