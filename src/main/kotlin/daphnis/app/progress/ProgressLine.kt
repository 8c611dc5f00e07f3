package daphnis.app.progress

import com.github.ajalt.mordant.terminal.Terminal
import java.util.Locale

/**
 * What there is to say about a run that began at time [start] and goes on. [left] is the time left in seconds, or not
 * finite when it is not known.
 *
 * @param timeUnit of [start], [time] and [until]; empty where it has no name
 * @param energyUnit the same for [energy]
 */
internal class ProgressLine(
    private val start: Double,
    private val time: Double,
    private val until: Double,
    private val step: Long,
    private val left: Double,
    private val collisionsPerSecond: Double,
    private val energy: Double,
    private val timeUnit: String = "",
    private val energyUnit: String = "",
) {
    /** The most that fits in [columns]; what matters less is left out first, and nothing is longer. */
    fun text(columns: Int): String {
        val percent = say("%3.0f %%", minOf(100.0, 100 * (time - start) / (until - start)))
        val clock = "${clock(left)} left"
        val long = listOf(
            percent,
            say("step %d", step),
            say("time %.4g of %.4g %s", time, until, timeUnit).trim(),
            clock,
            say("%.3g collisions/s", collisionsPerSecond),
            say("energy %.5g %s", energy, energyUnit).trim(),
        )
        val times = say("%.4g/%.4g", time, until)
        val candidates = listOf(
            long,
            long.dropLast(1),
            long.dropLast(2),
            listOf(percent, say("step %d", step), times, clock),
            listOf(percent, times, clock),
            listOf(percent, clock),
            listOf(percent),
        )
        val lines = candidates.map { it.joinToString("  ") }
        return lines.firstOrNull { it.length <= columns } ?: lines.last().take(maxOf(0, columns))
    }

    private fun say(format: String, vararg values: Any) = String.format(Locale.ROOT, format, *values)
}

/** [seconds] as hours, minutes and seconds; 0 when they are not finite. */
internal fun clock(seconds: Double): String {
    val s = if (seconds.isFinite()) Math.round(maxOf(0.0, seconds)) else 0
    fun say(format: String, vararg values: Any) = String.format(Locale.ROOT, format, *values)
    return if (s >= 3600) say("%d:%02d:%02d", s / 3600, s / 60 % 60, s % 60) else say("%d:%02d", s / 60, s % 60)
}

/**
 * Columns that a line which is written over may use: one less than the terminal has, or it would wrap; asked anew, for
 * windows change.
 */
internal fun columnsFor(terminal: Terminal): Int {
    val width = terminal.updateSize().width
    return (if (width > 0) width else USUAL_COLUMNS) - 1
}

private const val USUAL_COLUMNS = 80
