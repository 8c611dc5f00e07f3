package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage

/**
 * A quantity with its value.
 *
 * @property name what it is called on the page
 * @property error one standard error; NaN for none, either because there is none or, [isUncertain], because too few
 *   independent states tell it
 * @property key what it is called in `tables/numbers.csv` and among the [References]: lower case, and the same in every
 *   version, whatever the [name]; null for a number that stands on the page only
 */
internal class NumberRow(
    val name: String,
    val value: Double,
    val error: Double,
    val unit: String,
    val reference: Reference? = null,
    val note: String = "",
    val isUncertain: Boolean = false,
    val key: String? = null,
)

/** A list of quantities in the making; each gets the one of [references] that has its key. */
internal class NumberRows(private val references: Map<String, Reference> = emptyMap()) {
    private val rows = ArrayList<NumberRow>()

    /** The average [a] in [unit]. */
    fun average(key: String, name: String, a: BlockAverage, unit: String, note: String = "") {
        val isUncertain = !a.isLevelled && !a.mean.isNaN()
        rows += NumberRow(name, a.mean, a.error, unit, references[key], note, isUncertain, key)
    }

    /** A [value] without error, which follows from the particles themselves. */
    fun exact(key: String, name: String, value: Double, unit: String, note: String = "") {
        rows += NumberRow(name, value, Double.NaN, unit, references[key], note, key = key)
    }

    fun list(): List<NumberRow> = rows
}
