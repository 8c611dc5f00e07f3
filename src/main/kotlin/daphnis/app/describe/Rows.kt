package daphnis.app.describe

/** A description as rows of a label and a text; a label that is repeated is left out. */
internal class Rows {
    private val lines = ArrayList<String>()
    private var last = ""

    fun add(label: String, text: String) {
        lines += ((if (label == last) "" else label).padEnd(LABEL) + text).trimEnd()
        last = label
    }

    override fun toString(): String = lines.joinToString("\n")

    private companion object {
        const val LABEL = 18
    }
}
