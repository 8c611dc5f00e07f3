package daphnis.analysis.report

/**
 * What a number of the report means: the declaration of a key of `tables/numbers.csv`.
 *
 * @property key as in the table; a word in capitals stands for a name or number of the run
 * @property meaning in a line, with symbol and formula
 * @property unit of its value; empty for a pure number
 * @property whence where its definition is from; empty where the meaning is all of it
 * @property only what a run needs for it beside what its [KeyGroup] says; empty for nothing
 */
internal class ReportKey(
    val key: String,
    val meaning: String,
    val unit: String = "",
    val whence: String = "",
    val only: String = "",
) {
    private val pattern = Regex(key.replace(Regex("[A-Z]+"), ".+"))

    /** For those who look at the number: its key and meaning, and whence this is. */
    fun words(): String = "$key: $meaning" + if (whence.isEmpty()) "" else " ($whence)"

    fun matches(given: String): Boolean = pattern.matches(given)
}

/** Keys that runs of one kind have, with what these are. */
internal class KeyGroup(val heading: String, val runs: String, val keys: List<ReportKey>)

/** All keys of `tables/numbers.csv`, from which `docs/reference/numbers.md` is made: each is declared here once. */
internal object ReportKeys {
    val groups: List<KeyGroup> = RingKeys.groups + BoxKeys.groups

    /** The declaration of [key]; null where there is none. */
    fun of(key: String): ReportKey? = all.find { it.key == key } ?: all.find { it.matches(key) }

    val all: List<ReportKey> get() = groups.flatMap { it.keys }
}
