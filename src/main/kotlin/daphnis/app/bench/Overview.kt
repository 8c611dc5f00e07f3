package daphnis.app.bench

import daphnis.app.describe.spheres
import java.util.Locale
import kotlin.math.ceil
import kotlin.math.roundToLong

/** What a bench is going to do, and how long that still takes. */
internal class Overview(
    private val contests: List<Contest>,
    private val contestants: List<Contestant>,
    private val rounds: Int,
    private val warmUp: Double,
) {
    /** All of it, line by line. */
    fun lines(): List<String> {
        val turns = contests.size * contestants.size * rounds
        val counted = if (rounds == 1) "1 round that counts" else "$rounds rounds that count"
        val warm = if (warmUp == 0.0) "one turn" else "${"$warmUp".removeSuffix(".0")} s of turns, one at least,"
        return contests.map { "${it.name}: ${spheres(it.spheres)}, ${it.span}" } + listOf(
            "engines: ${engines()}",
            "$warm for each to warm up, then $counted: " +
                "${contests.size} x ${contestants.size} x $rounds (scenarios x engines x rounds) = $turns turns",
        )
    }

    /** `serial on 1 thread; horizon, actors on 1, 2 threads`. */
    private fun engines(): String {
        val threads = contestants.groupBy({ it.engine }, { it.threads })
        return threads.keys.groupBy { threads.getValue(it) }.entries.joinToString("; ") { (counts, engines) ->
            val word = if (counts == listOf(1)) "thread" else "threads"
            "${engines.joinToString()} on ${counts.joinToString()} $word"
        }
    }

    /**
     * How long it takes after [round] of the scenario at [index] when a round takes [seconds]; null at the end. Round 0
     * is what warms up. Scenarios that have not begun are taken to need as long per sphere and step.
     */
    fun left(index: Int, round: Int, seconds: Double): String? {
        val here = (rounds - round) * seconds
        val next = contests.drop(index + 1)
        val name = contests[index].name
        if (next.isEmpty()) return if (round == rounds) null else "about ${words(here)} left"
        val count = if (next.size == 1) "one scenario" else "${next.size} scenarios"
        val own = contests[index].work
        val works = next.map { it.work }
        val all = if (own == null || null in works) {
            "$count after it"
        } else {
            val later = works.sumOf { (seconds * it!! / own).let { s -> rounds * s + warmedIn(s) } }
            "roughly ${words(here + later)} with $count after it"
        }
        return if (round == rounds) "$name is done; $all" else "about ${words(here)} left of $name, $all"
    }

    /** How long warming up takes when a round takes [seconds]: turns go on until there have been enough. */
    private fun warmedIn(seconds: Double): Double {
        val needed = warmUp * contestants.size
        return if (seconds > 0) seconds * maxOf(1.0, ceil(needed / seconds)) else needed
    }

    private fun words(seconds: Double): String = when {
        seconds < 1.5 * MINUTE -> "${maxOf(1, seconds.roundToLong())} s"
        seconds < 1.5 * HOUR -> "${(seconds / MINUTE).roundToLong()} min"
        else -> "%.1f h".format(Locale.ROOT, seconds / HOUR)
    }

    private companion object {
        const val MINUTE = 60.0
        const val HOUR = 3600.0
    }
}
