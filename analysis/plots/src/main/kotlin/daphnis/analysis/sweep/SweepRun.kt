package daphnis.analysis.sweep

import daphnis.analysis.report.ReportNumber

/**
 * A run of a sweep.
 *
 * @property name of its directory
 * @property values of the swept keys, as they were given, in the order of [Sweep.keys]
 * @property seed of its initial state
 * @property numbers that it came to; empty when it failed
 * @property failure why it failed; null when it is finished
 * @property remark what is to be said of all numbers of a finished run, such as why some are missing; null for nothing.
 *   Which ones are not steady they say themselves
 */
public class SweepRun @JvmOverloads constructor(
    public val name: String,
    public val values: List<String>,
    public val seed: Long,
    public val numbers: List<ReportNumber>,
    public val failure: String? = null,
    public val remark: String? = null,
) {
    /** Whether all its averages are over a time in which it does not drift. */
    public val isSteady: Boolean get() = numbers.all { it.isSteady }

    /** Whether it can be told of all its averages. */
    internal val isJudged: Boolean get() = numbers.all { it.isJudged }

    /** What is to be said of its averages; null for nothing. */
    internal val ofSteadiness: String? get() = if (!isSteady) {
        UNSTEADY
    } else if (!isJudged) {
        UNJUDGED
    } else {
        null
    }

    internal companion object {
        const val UNSTEADY = "not steady over the time averaged"
        const val UNJUDGED = "not known to be steady: too few rows in the time averaged"
    }
}
