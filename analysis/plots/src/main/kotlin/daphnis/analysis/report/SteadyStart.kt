package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.statistics.Steadiness.Verdict

/**
 * From when on averages are taken where nobody says.
 *
 * @property from the time
 * @property isFound whether the run drifts over the usual time, and is steady from this later one on
 */
internal class SteadyStart private constructor(val from: Double, val isFound: Boolean) {
    companion object {
        /**
         * The [usual] time, unless the run drifts from there on and is steady from a later time, that at which by
         * MSER-5 the last of its main quantities becomes so. One that cools for ever is not. A run that is steady
         * anyway is left at the usual time: to choose for each the time that looks best would make errors too small.
         */
        fun of(input: AnalysisInput, usual: Double): SteadyStart {
            if (FreeCooling.isSeen(input)) return SteadyStart(usual, false)
            return of(usual) { RunHistory.of(input, it) }
        }

        /** The same for the [histories] that tell of the time from a given one on. */
        fun of(usual: Double, histories: (from: Double) -> List<History>): SteadyStart {
            val stay = SteadyStart(usual, false)
            val all = histories(usual)
            if (all.none { it.steadiness(usual).verdict == Verdict.DRIFTING }) return stay
            val later = all.maxOf { it.steadyFrom() ?: return stay }
            val isSteady = later > usual && histories(later).all { it.steadiness(later).verdict == Verdict.STEADY }
            return if (isSteady) SteadyStart(later, true) else stay
        }
    }
}
