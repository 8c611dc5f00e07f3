package daphnis.analysis.report

import daphnis.analysis.statistics.Steadiness
import daphnis.analysis.statistics.Steadiness.Verdict
import java.util.Locale
import kotlin.math.abs

/**
 * Says in words whether a run is steady from the time [from] on.
 *
 * @param unit what [duration] is one of, such as `orbit`
 * @param duration a length of time, by which drifts are given
 * @param isCooling whether it never becomes steady, see [FreeCooling]
 * @param otherwise what to do about a drift of a run that has no steady part
 */
internal class SteadinessText(
    private val from: Double,
    private val unit: String,
    private val duration: Double,
    private val isCooling: Boolean = false,
    private val otherwise: String = "a longer run is needed",
) {
    /**
     * One sentence for each of the [histories] that drifts, then one for those that do not, with the largest drift that
     * may have been missed, and one for those that are too short to tell.
     */
    fun of(histories: List<History>): List<String> {
        val lines = ArrayList<String>()
        val steady = ArrayList<String>()
        val short = ArrayList<String>()
        for (history in histories) {
            val found = history.steadiness(from)
            when (found.verdict) {
                Verdict.TOO_SHORT -> short += history.name
                Verdict.STEADY -> steady += "${history.name} ${percent(found.largest / average(history))}"
                Verdict.DRIFTING -> lines += drift(history, found, histories.size)
            }
        }
        if (steady.isNotEmpty()) {
            lines +=
                "No drift is seen over the time averaged. A smaller one than this part of the average may have been " +
                "missed, with 95 % confidence: ${steady.joinToString()}."
        }
        if (short.isNotEmpty()) {
            lines += "Whether it is steady cannot be told from fewer than ${Steadiness.FEWEST} rows " +
                "in the time averaged: ${short.joinToString()}."
        }
        return lines
    }

    private fun drift(history: History, found: Steadiness, judged: Int): String {
        val first = history.first(from)
        val part = found.change / average(history)
        val what = if (part < 0) "fell" else "rose"
        val each = percent(abs(part) * duration / (history.times.last() - history.times[first]))
        val lost = if (found.isDriftingAmong(judged)) "no ± is given" else "what goes with it has no ±"
        val mser = history.steadyFrom()
        val advice = when {
            isCooling -> "nothing replaces the energy that collisions take, so a longer run is not steady either"
            mser != null && mser > from -> "by MSER-5 it is steady from time ${time(mser)} on (--from)"
            else -> otherwise
        }
        return "Not steady: ${history.name} $what by ${percent(abs(part))} of its average over the time averaged " +
            "($each per $unit), more than its fluctuations explain, so $lost; $advice."
    }

    /** That averages begin where the run was found to become steady. */
    fun found(): String = "The run became steady at time ${time(from)}, by MSER-5; averages begin there."

    /** Size of the average of [history] over the time averaged. */
    private fun average(history: History) =
        abs(history.values.copyOfRange(history.first(from), history.values.size).average())

    private fun time(time: Double): String {
        val inOrbits = if (unit == "orbit") " (${ReportText.short(time / duration)} orbits)" else ""
        return ReportText.short(time) + inOrbits
    }

    private fun percent(part: Double) =
        String.format(Locale.ROOT, if (part < 0.1) "%.2g" else "%.0f", 100 * part) + " %"
}
