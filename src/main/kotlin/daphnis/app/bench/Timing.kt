package daphnis.app.bench

import daphnis.core.Engines

/**
 * How long an engine took for the steps of a scenario.
 *
 * @property spheres at the start
 * @property threads with which the engine worked
 * @property steps in each round
 * @property collisions in each round
 * @property seconds by round
 * @property processorSeconds of all threads of the JVM by round, its compilers' and collector's too; NaN where unknown
 * @property java version that ran it; empty where unknown
 */
internal class Timing(
    val scenario: String,
    val spheres: Int,
    val engine: String,
    val threads: Int,
    val steps: Long,
    val collisions: Long,
    val seconds: List<Double>,
    val processorSeconds: List<Double>,
    val java: String,
) {
    /** The round that was disturbed least by what else the machine did. */
    val fastest: Double get() = seconds.min()

    /** What the [fastest] round took of all processors together; NaN where unknown. */
    val processorOfFastest: Double get() = processorSeconds[seconds.indexOf(fastest)]

    /** Half of the rounds took longer; the mean of the middle two for an even number of rounds. */
    val median: Double
        get() {
            val sorted = seconds.sorted()
            return (sorted[(sorted.size - 1) / 2] + sorted[sorted.size / 2]) / 2
        }
    val millisecondsPerStep: Double get() = fastest * MILLI / steps

    /** NaN when nothing collided. */
    val microsecondsPerCollision: Double get() = if (collisions == 0L) Double.NaN else fastest * MICRO / collisions

    private companion object {
        const val MILLI = 1e3
        const val MICRO = 1e6
    }
}

/** The timings of one scenario, of which one is what the others are compared with. */
internal class Ranking(val timings: List<Timing>) {
    /** The serial engine where it took part, else the first on one thread, else the first. */
    val yardstick: Timing =
        timings.find { Engines.isSpecification(it.engine) } ?: timings.find { it.threads == 1 } ?: timings.first()

    /** How many times as fast as the [yardstick]. */
    fun speed(timing: Timing): Double = yardstick.fastest / timing.fastest

    /** Speed per thread, relative to the same engine on one thread; NaN when that was not timed. */
    fun efficiency(timing: Timing): Double {
        val alone = timings.find { it.engine == timing.engine && it.threads == 1 } ?: return Double.NaN
        return alone.fastest / timing.fastest / timing.threads
    }
}
