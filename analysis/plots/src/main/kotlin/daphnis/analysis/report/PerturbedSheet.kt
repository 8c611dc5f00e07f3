package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.State
import daphnis.core.boundary.at
import daphnis.core.boundary.isChanging
import kotlin.math.PI

/** What a report has to know of a sheet whose images breathe. */
internal object PerturbedSheet {
    /** Whether that of [state] is one. */
    fun isSeen(state: State): Boolean = state.boundary.isChanging && state.frequencies != null

    /** The period of the perturbation in the run of [input], of which [last] is a state; null where there is none. */
    fun period(input: AnalysisInput, last: State): Double? =
        input.frequencies?.takeIf { isSeen(last) }?.let { 2 * PI / it.kappa }

    /** q: of the widths that the box of [state] has the largest less the least over their sum. */
    fun q(state: State): Double {
        val narrowest = state.boundary.at(0.0).box.length(0)
        val widest = state.boundary.at(PI / state.frequencies!!.kappa).box.length(0)
        return (widest - narrowest) / (widest + narrowest)
    }
}
