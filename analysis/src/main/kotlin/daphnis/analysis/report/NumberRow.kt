package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage

/**
 * A quantity with its value.
 *
 * @property name what it is called in the report, in `tables/numbers.csv` and among the [References]: it stays as it is
 *   from version to version
 * @property error one standard error; NaN for none, either because there is none or, [isUncertain], because too few
 *   independent states tell it
 */
internal class NumberRow(
    val name: String,
    val value: Double,
    val error: Double,
    val unit: String,
    val reference: Reference? = null,
    val note: String = "",
    val isUncertain: Boolean = false,
)

/** A list of quantities in the making; each gets the one of [references] that has its name. */
internal class NumberRows(private val references: Map<String, Reference> = emptyMap()) {
    private val rows = ArrayList<NumberRow>()

    /** The average [a] in [unit]. */
    fun average(name: String, a: BlockAverage, unit: String, note: String = "") {
        rows += NumberRow(name, a.mean, a.error, unit, references[name], note, !a.isLevelled && !a.mean.isNaN())
    }

    /** A [value] without error, which follows from the particles themselves. */
    fun exact(name: String, value: Double, unit: String, note: String = "") {
        rows += NumberRow(name, value, Double.NaN, unit, references[name], note)
    }

    fun list(): List<NumberRow> = rows
}
