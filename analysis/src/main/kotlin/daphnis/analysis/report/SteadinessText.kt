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
 */
internal class SteadinessText(private val from: Double, private val unit: String, private val duration: Double) {
    /**
     * One sentence for each [history] that drifts, then one for those that do not, and one for those that are too short
     * to tell.
     */
    fun of(histories: List<History>): List<String> {
        val lines = ArrayList<String>()
        val steady = ArrayList<String>()
        val short = ArrayList<String>()
        for (history in histories) {
            val first = history.times.indexOfFirst { it >= from }.let { if (it < 0) history.times.size else it }
            val values = history.values.copyOfRange(first, history.values.size)
            val found = Steadiness.of(values)
            val mean = values.average()
            when {
                found.verdict == Verdict.TOO_SHORT -> short += history.name
                found.verdict == Verdict.STEADY || abs(found.change) <= NEGLIGIBLE * abs(mean) -> steady += history.name
                else -> lines += drift(history, found.change / abs(mean), history.times.last() - history.times[first])
            }
        }
        if (steady.isNotEmpty()) lines += "No drift is seen over the time averaged: ${steady.joinToString()}."
        if (short.isNotEmpty()) {
            lines += "Whether it is steady cannot be told from fewer than ${Steadiness.FEWEST} rows " +
                "in the time averaged: ${short.joinToString()}."
        }
        return lines
    }

    private fun drift(history: History, part: Double, time: Double): String {
        val what = if (part < 0) "fell" else "rose"
        val each = percent(abs(part) * duration / time)
        val mser = Steadiness.steadyFrom(history.values).let { if (it < 0) null else history.times[it] }
        val advice = if (mser != null && mser > from) {
            val inOrbits = if (unit == "orbit") " (${ReportText.short(mser / duration)} orbits)" else ""
            "by MSER-5 it is steady from time ${ReportText.short(mser)}$inOrbits on (--from)"
        } else {
            "a longer run is needed"
        }
        return "Not steady: ${history.name} $what by ${percent(abs(part))} of its average over the time averaged " +
            "($each per $unit), more than its fluctuations explain; ± does not include this; $advice."
    }

    private fun percent(part: Double) =
        String.format(Locale.ROOT, if (part < 0.1) "%.2g" else "%.0f", 100 * part) + " %"

    private companion object {
        /** Change, as a part of the average, that is not worth a word. */
        const val NEGLIGIBLE = 1e-3
    }
}
