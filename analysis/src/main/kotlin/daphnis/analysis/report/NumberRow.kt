package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage

/**
 * A row of the table of numbers; [error] NaN for none, either because there is none or, [isUncertain], because too few
 * independent states tell it.
 */
internal class NumberRow(
    val what: String,
    val value: Double,
    val error: Double,
    val unit: String,
    val reference: Reference? = null,
    val note: String = "",
    val isUncertain: Boolean = false,
) {
    companion object {
        /** The average [a] in [unit]. */
        fun of(what: String, a: BlockAverage, unit: String, reference: Reference? = null, note: String = "") =
            NumberRow(what, a.mean, a.error, unit, reference, note, !a.isLevelled && !a.mean.isNaN())
    }
}
