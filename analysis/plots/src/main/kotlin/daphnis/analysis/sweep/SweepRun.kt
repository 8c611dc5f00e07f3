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
 * @property remark what is to be said of the numbers of a finished run, such as why some are missing; null for nothing
 */
public class SweepRun @JvmOverloads constructor(
    public val name: String,
    public val values: List<String>,
    public val seed: Long,
    public val numbers: List<ReportNumber>,
    public val failure: String? = null,
    public val remark: String? = null,
)
