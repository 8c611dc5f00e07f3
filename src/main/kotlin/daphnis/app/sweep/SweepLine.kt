package daphnis.app.sweep

import java.util.Locale

/**
 * How far a sweep has come.
 *
 * @property finished runs, of [all]; [failed] and [busy] are not among them
 * @property busy those at which other processes are
 * @property running runs that go on; 0 to be silent about them
 * @property part of the whole, from 0 to 1
 * @property left seconds left; NaN when that is not known
 */
internal class SweepLine(
    private val finished: Int,
    private val failed: Int,
    private val busy: Int,
    private val running: Int,
    private val all: Int,
    private val part: Double,
    private val left: Double,
) {
    /** The most that fits in [columns]; what matters less is left out first, and nothing is longer. */
    fun text(columns: Int): String {
        val percent = String.format(Locale.ROOT, "%3.0f %%", 100 * part)
        // Of all steps, not of the runs that are named behind.
        val ofWork = "$percent of the work"
        val done = "$finished of $all ${if (all == 1) "run" else "runs"}"
        val bad = listOfNotNull("$failed failed".takeIf { failed > 0 }, "$busy busy".takeIf { busy > 0 })
            .joinToString("  ").ifEmpty { null }
        val now = if (running > 0) "$running running" else null
        val clock = if (left.isFinite() && part < 1) "${clock(left)} left" else null
        val lines = listOf(
            listOf(ofWork, "$done finished", now, bad, clock),
            listOf(ofWork, "$done finished", bad, clock),
            listOf(percent, done, bad),
            listOf(percent),
        ).map { it.filterNotNull().joinToString("  ") }
        return lines.firstOrNull { it.length <= columns } ?: lines.last().take(maxOf(0, columns))
    }

    private fun clock(seconds: Double): String {
        val s = Math.round(maxOf(0.0, seconds))
        fun say(format: String, vararg values: Any) = String.format(Locale.ROOT, format, *values)
        return if (s >= 3600) say("%d:%02d:%02d", s / 3600, s / 60 % 60, s % 60) else say("%d:%02d", s / 60, s % 60)
    }
}
