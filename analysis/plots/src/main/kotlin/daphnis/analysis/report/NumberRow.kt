package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage

/**
 * A quantity with its value.
 *
 * @property name what it is called on the page
 * @property error one standard error; NaN for none, either because there is none or because it is [unknown]
 * @property unknown why an average has no error; null when it has one, or is no average
 * @property key what it is called in `tables/numbers.csv` and among the [References]: lower case, and the same in every
 *   version, whatever the [name]; null for a number that stands on the page only
 * @property isOfChange whether it tells how the run changes, so that its error holds where the run is not steady
 */
internal class NumberRow(
    val name: String,
    val value: Double,
    val error: Double,
    val unit: String,
    val reference: Reference? = null,
    val note: String = "",
    val unknown: Unknown? = null,
    val key: String? = null,
    val isOfChange: Boolean = false,
) {
    /** Whether it is an average, not a number that follows from the particles themselves. */
    val isAverage: Boolean get() = !isOfChange && (!error.isNaN() || unknown != null)

    /**
     * This average without an error, for [why], such as a time in which the run was not steady: an error would say that
     * more is known than is. That there are too few states for one then matters less: more of them would not help.
     */
    fun without(why: Unknown): NumberRow =
        if (isAverage) NumberRow(name, value, Double.NaN, unit, reference, note, why, key) else this
}

/**
 * Why an average has no error.
 *
 * @property remark in `numbers.csv`
 * @property mark behind the value on the page
 * @property sentence below the table
 */
internal enum class Unknown(val remark: String, val mark: String, val sentence: String, val longer: Int? = null) {
    TOO_FEW(
        "too few independent states",
        "?",
        "No error can be given: it takes 16 states or rows, which are worth eight independent ones.",
        longer = 4,
    ),
    SHORT_TIME(
        "too short for its lags",
        "†",
        "No error can be given: the time averaged is shorter than six times the longest lag of the fit.",
        // A fit ends at half the time at most, and may take lags that are twice as long when there are any.
        longer = 6,
    ),
    UNSTEADY("not steady", "!", "No error is given: the run is not steady over the time averaged."),
    ONE_STATE("not steady", "!", "No error is given: the number is of one state of a run that changes."),
    FEW_PHASES(
        "states of few phases",
        "‡",
        "No error is given: the states are of few phases of the radial period, so this is no mean over it.",
    ),
}

/** A list of quantities in the making; each gets the one of [references] that has its key. */
internal class NumberRows(private val references: Map<String, Reference> = emptyMap()) {
    private val rows = ArrayList<NumberRow>()

    /** The average [a] in [unit]; without a [key] it stands on the page only. */
    fun average(key: String?, name: String, a: BlockAverage, unit: String, note: String = "") {
        val unknown = if (!a.isLevelled && !a.mean.isNaN()) Unknown.TOO_FEW else null
        rows += NumberRow(name, a.mean, a.error, unit, references[key], note, unknown, key)
    }

    /** A [value] without error, which follows from the particles themselves. */
    fun exact(key: String?, name: String, value: Double, unit: String, note: String = "") {
        rows += NumberRow(name, value, Double.NaN, unit, references[key], note, key = key)
    }

    /** A [value] that tells how the run changes, and its standard [error]; NaN where it is not known. */
    fun change(key: String?, name: String, value: Double, error: Double, unit: String, note: String = "") {
        val unknown = Unknown.TOO_FEW.takeIf { error.isNaN() && !value.isNaN() }
        rows += NumberRow(name, value, error, unit, references[key], note, unknown, key, isOfChange = true)
    }

    fun list(): List<NumberRow> = rows
}
