package daphnis.app.bench

import daphnis.analysis.plot.Yardstick
import daphnis.app.describe.counted
import daphnis.app.describe.spheres
import daphnis.core.input.oneLine
import java.util.Locale

/** Timings of one scenario as a table in Markdown. */
internal fun timingTable(timings: List<Timing>): String {
    val ranking = Ranking(timings)
    val lines = ArrayList<String>()
    val times = arrayOf("fastest, s", "median, s", "processor, s")
    lines += row("engine", "threads", *times, "ms per step", "µs per collision", "speed", "efficiency")
    lines += "|---|--:|--:|--:|--:|--:|--:|--:|--:|"
    for (t in timings) {
        lines += row(
            t.engine,
            "${t.threads}",
            significant(t.fastest),
            significant(t.median),
            hundredths(t.processorOfFastest),
            significant(t.millisecondsPerStep),
            significant(t.microsecondsPerCollision),
            hundredths(ranking.speed(t)),
            hundredths(ranking.efficiency(t)),
        )
    }
    return lines.joinToString("\n")
}

/** What a table of [timings] is about, in one line. */
internal fun timingTitle(timings: List<Timing>): String {
    val t = timings.first()
    val rounds = if (t.seconds.size == 1) "1 round" else "${t.seconds.size} rounds"
    val done = "${counted(t.steps, "step")}, ${counted(t.collisions, "collision")}"
    val work = "${oneLine(t.scenario)}: ${spheres(t.spheres)}, $done"
    val yardstick = Ranking(timings).yardstick.let { Yardstick(it.engine, it.threads, it.fastest) }
    return "$work; $rounds; speed relative to $yardstick"
}

/** Of a table; names in it come from files. */
internal fun row(vararg cells: String): String = cells.joinToString(" | ", "| ", " |", transform = ::oneLine)

/** [value] to two decimals; empty for NaN. */
internal fun hundredths(value: Double): String = if (value.isNaN()) "" else "%.2f".format(Locale.ROOT, value)

/** [value] to three digits; empty for NaN. */
internal fun significant(value: Double): String = when {
    value.isNaN() -> ""
    value >= 99.95 -> "%.0f".format(Locale.ROOT, value)
    value >= 9.995 -> "%.1f".format(Locale.ROOT, value)
    value >= 0.9995 -> "%.2f".format(Locale.ROOT, value)
    else -> "%.3g".format(Locale.ROOT, value)
}
