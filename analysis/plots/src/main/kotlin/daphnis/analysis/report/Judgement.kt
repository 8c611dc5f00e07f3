package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.statistics.Steadiness.Verdict

/**
 * Whether averages from the time [from] on are over a steady time, and so whether they have errors.
 *
 * @param states how many states averages are over
 * @param isChanging whether it is known that they are not
 * @param isOfFewPhases whether the states are not spread over the period with which all changes, so that no average over
 *   them has an error
 * @param ofRows keys of the numbers that are averages over rows, and not over states
 * @param quantities the main ones over time, of which each is judged; asked for once, when all states have been seen
 */
internal class Judgement(
    private val from: Double,
    private val states: Int,
    private val isChanging: Boolean = false,
    private val isOfFewPhases: Boolean = false,
    private val ofRows: Set<String> = emptySet(),
    quantities: () -> List<History>,
) {
    /** Those that change at all. */
    val histories: List<History> by lazy { quantities().filterNot { it.isConstant(from) } }

    private val found by lazy { histories.map { it.steadiness(from) } }

    /**
     * Whether the run as a whole is not steady over the time averaged: one of the main quantities drifts by more than
     * chance makes of so many.
     */
    val isDrifting by lazy { isChanging || found.any { it.isDriftingAmong(histories.size) } }

    /** Numbers that drift, each by itself: those of a main quantity that does. */
    private val drifting: Set<String?> by lazy {
        histories.indices.filter { found[it].verdict == Verdict.DRIFTING }.flatMap { histories[it].keys }.toSet()
    }

    /** Whether none is seen to drift, but one has too few rows to tell. */
    val isUnjudged by lazy { !isDrifting && found.any { it.verdict == Verdict.TOO_SHORT } }

    /**
     * The standard error of [average] over states, NaN where the run or the number with the [key] drifts, which it is
     * part of.
     */
    fun error(average: BlockAverage, key: String? = null): Double =
        if (isDrifting || isOfFewPhases || key in drifting) Double.NaN else average.error

    /** [errors] of averages over states, NaN where the run drifts. */
    fun errors(errors: DoubleArray): DoubleArray =
        if (isDrifting || isOfFewPhases) DoubleArray(errors.size) { Double.NaN } else errors

    /**
     * [rows] as they are shown: averages over a time in which they, or the run, drift have no error. Nor have those
     * that follow the temperature of a box where this changes too slowly for an error of its own (docs/adr/0181).
     */
    fun shown(rows: List<NumberRow>): List<NumberRow> {
        val isSlow = rows.any { it.key == RunHistory.TEMPERATURE && it.unknown == Unknown.TOO_FEW }
        return rows.map {
            when {
                isDrifting || it.key in drifting -> it.without(why)
                isOfFewPhases && it.key !in ofRows -> it.without(Unknown.FEW_PHASES)
                isSlow && !it.error.isNaN() && RunHistory.followsTemperature(it.key) -> it.without(Unknown.TOO_FEW)
                else -> it
            }
        }
    }

    /** Whether nothing is averaged, since no time of the run is like another. */
    private val isOfOne get() = isChanging && states == 1
    private val why get() = if (isOfOne) Unknown.ONE_STATE else Unknown.UNSTEADY

    /** What the bars of a chart are; [steady] where the run does not drift. */
    fun bars(steady: String = ofStates()): String = when {
        isOfOne -> NOT_OF_ONE
        isDrifting -> NO_BARS
        isOfFewPhases -> NOT_OF_PERIOD
        else -> steady
    }

    private fun ofStates(): String {
        if (states >= BlockAverage.FEWEST_NUMBERS) return BARS
        return "There are no bars: ${ReportText.count(states, "state")} ${if (states == 1) "is" else "are"} too few."
    }

    private companion object {
        const val BARS =
            "Bars are one standard error; a point has none where fewer than ${BlockAverage.FEWEST_NUMBERS} states " +
                "have a value, where these are worth fewer than eight independent ones, or where what it is part of " +
                "drifts."
        const val NOT_OF_ONE = "There are no bars: numbers are of one state."
        const val NOT_OF_PERIOD = "There are no bars, since the states are of few phases of the radial period."
        const val NO_BARS = "There are no bars, since the run is not steady over the time averaged."
    }
}
