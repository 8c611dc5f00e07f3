package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.State
import daphnis.core.boundary.at
import daphnis.core.boundary.isChanging
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.hypot
import kotlin.math.roundToInt
import kotlin.math.sin

/** What a report has to know of a sheet whose images breathe. */
internal object PerturbedSheet {
    /** Whether that of [state] is one. */
    fun isSeen(state: State): Boolean = state.boundary.isChanging && state.frequencies != null

    /** The period of the perturbation in the run of [input], of which [last] is a state; null where there is none. */
    fun period(input: AnalysisInput, last: State): Double? =
        input.frequencies?.takeIf { isSeen(last) }?.let { 2 * PI / it.kappa }

    /** Keys of numbers of the flux of angular momentum. */
    val FLUXES: Set<String> = setOf("angular_momentum_flux", "angular_momentum_flux_translational")

    /**
     * Whether the states [chosen] of the run of [input], of which [last] is one, are of few phases of the period, so that
     * averages over them are no means over it: exp(iκt) of them is not 0 on average. False where there is no period.
     */
    fun isOfFewPhases(input: AnalysisInput, last: State, chosen: List<Int>): Boolean {
        val period = period(input, last) ?: return false
        val phase = chosen.map { 2 * PI * (input.times[it] / period) }
        return hypot(phase.sumOf { cos(it) }, phase.sumOf { sin(it) }) > MOST_OF_ONE * phase.size
    }

    /** That the states that are averaged are of few phases, and what helps; null where they are not. */
    fun remark(study: Study): String? {
        if (!isOfFewPhases(study.input, study.last, study.averaged)) return null
        val late = study.input.times.indices.filter { study.input.times[it] >= study.from }
        val help = if (late.size > study.averaged.size && !isOfFewPhases(study.input, study.last, late)) {
            "${late.size} frames would take all that there are"
        } else {
            "a run with ${spread(study)} would have them"
        }
        return "The ${ReportText.count(study.averaged.size, "state")} averaged are not spread over the phases of the " +
            "radial period, so numbers that are of states are no means over it and have no ±: $help."
    }

    /** What writes states at other phases each time: some 0.38 of the period later, beside whole ones. */
    private fun spread(study: Study): String {
        val output = study.input.scenario?.output
        val times = study.input.times
        if (output == null || output.snapshotInterval != null || output.snapshotEvery < 1 || times.size < 3) {
            return "states $GOLDEN of the period apart, beside whole ones,"
        }
        val period = period(study.input, study.last)!!
        val apart = times[1] - times[0]
        val every = (floor(apart / period + ROUNDING) + GOLDEN) * period / apart * output.snapshotEvery
        return "output.snapshotEvery=${every.roundToInt()}"
    }

    /** q: of the widths that the box of [state] has the largest less the least over their sum. */
    fun q(state: State): Double {
        val narrowest = state.boundary.at(0.0).box.length(0)
        val widest = state.boundary.at(PI / state.frequencies!!.kappa).box.length(0)
        return (widest - narrowest) / (widest + narrowest)
    }

    /** Length of the mean of exp(iκt) from which states count as being of few phases; 1 of states of one. */
    private const val MOST_OF_ONE = 0.3

    /** The part of a turn whose multiples are spread most evenly. */
    private const val GOLDEN = 0.38
    private const val ROUNDING = 1e-6
}
