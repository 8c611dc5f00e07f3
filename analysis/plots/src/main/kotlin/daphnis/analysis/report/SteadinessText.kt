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
 * @param growing what to do where something grows in the time averaged; null where nothing does
 */
internal class SteadinessText(
    private val from: Double,
    private val unit: String,
    private val duration: Double,
    private val isCooling: Boolean = false,
    private val otherwise: String = "a longer run is needed",
    private val growing: String? = null,
) {
    /**
     * One sentence for each of the [histories] that drifts, which takes the ± of the run if one of them does, with
     * what to do about it in the last of those for which that is the same; then one for those that do not, with the
     * largest drift that may have been missed, one for those whose fluctuations may hide a large one, and one for
     * those with too few rows to tell. Of a conserved quantity no drift is missed.
     */
    fun of(histories: List<History>): List<String> {
        val found = histories.map { it to it.steadiness(from) }.groupBy { it.second.verdict }
        val drifts = found[Verdict.DRIFTING].orEmpty()
        val isRun = drifts.any { it.second.isDriftingAmong(histories.size) }
        val drifting = drifts.map { (history, drift) -> drift(history, drift, isRun) to advice(history) }
        val lines = drifting.mapIndexedTo(ArrayList()) { k, (said, advice) ->
            if (drifting.drop(k + 1).any { it.second == advice }) "$said." else "$said; $advice."
        }
        found[Verdict.STEADY]?.let { lines += steady(it, lines.size) }
        found[Verdict.TOO_SHORT]?.let { short ->
            lines += "Whether it is steady cannot be told from fewer than ${Steadiness.FEWEST} rows " +
                "in the time averaged: ${short.joinToString { rows(it.first) }}."
        }
        return lines
    }

    private fun steady(found: List<Pair<History, Steadiness>>, drifting: Int): List<String> {
        val (told, untold) = found.map { (history, drift) -> history.name to drift.largest / average(history) }
            .partition { !(it.second > MOST_MISSED) }
        val where = when {
            drifting == 0 && untold.isEmpty() -> "over the time averaged"
            untold.isNotEmpty() -> "in ${told.joinToString { it.first }}"
            found.size == 1 -> "in the other quantity"
            else -> "in the other quantities"
        }
        val missed = told.filter { it.second > ROUND_OFF }
        val parts = missed.joinToString { (name, part) -> "$name ${percent(part)}" }
        val of = if (missed.isEmpty()) "" else " $MISSED: $parts."
        return listOfNotNull(
            "No drift is seen $where.$of".takeIf { told.isNotEmpty() },
            "Whether it is steady cannot be told of ${untold.joinToString { it.first }}: $HIDDEN."
                .takeIf { untold.isNotEmpty() },
        )
    }

    /** How many rows of [history] tell of the time averaged. */
    private fun rows(history: History): String {
        val all = history.values.size
        val there = all - history.first(from)
        return if (there <
            Steadiness.FEWEST
        ) {
            "${history.name} ($there of $all)"
        } else {
            "${history.name} (not all numbers)"
        }
    }

    private fun drift(history: History, found: Steadiness, isRun: Boolean): String {
        val first = history.first(from)
        val part = found.change / average(history)
        val what = if (part < 0) "fell" else "rose"
        val size = abs(part)
        val much = if (size < 1) "${percent(size)} of its average" else "${ReportText.short(size)} times its average"
        val each = percent(size * duration / (history.times.last() - history.times[first]))
        val lost = if (isRun) "no ± is given" else "what goes with it has no ±"
        return "Not steady: ${history.name} $what by $much over the time averaged " +
            "($each per $unit), more than its fluctuations explain, so $lost"
    }

    private fun advice(history: History): String {
        val mser = history.steadyFrom()
        return when {
            isCooling -> COOLING
            growing != null -> growing
            mser != null && mser > from -> "by MSER-5 it is steady from time ${time(mser)} on (--from)"
            else -> otherwise
        }
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

    private companion object {
        /** Part of an average below which a change is an error of rounding: the quantity is conserved. */
        const val ROUND_OFF = 1e-9

        /** Part of an average above which a drift that may have been missed leaves open whether it is steady. */
        const val MOST_MISSED = 0.25
        const val COOLING = "nothing replaces the energy that collisions take, so a longer run is not steady either; " +
            "a thermostat makes one that is (--set 'forces=[{\"type\":\"rescaling\",\"temperature\":1}]'). " +
            "Cumulants and ratios of temperatures may be steady meanwhile, but have no ± either: " +
            "its spheres get slower, so its later states are less independent than the earlier ones"
        const val HIDDEN = "a drift of a quarter of the average may hide in the fluctuations"
        const val MISSED = "A smaller one than this part of the average may have been missed, with 95 % confidence"
    }
}
