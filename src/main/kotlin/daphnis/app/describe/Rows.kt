package daphnis.app.describe

import daphnis.core.input.oneLine

/**
 * A description as rows of a label and a text; a label that is repeated is left out.
 *
 * @param label columns for labels
 */
internal class Rows(private val label: Int = LABEL) {
    private val rows = ArrayList<Pair<String, String>>()
    private var last = ""

    /** Adds one line of [text], in which nothing is obeyed, not even a line end. */
    fun add(label: String, text: String) {
        rows += (if (label == last) "" else label) to oneLine(text)
        last = label
    }

    /**
     * The rows in lines of at most [columns], broken between words; longer words stand alone. Texts stand beside their
     * labels, and where that leaves too little for them, below.
     */
    fun text(columns: Int = Int.MAX_VALUE): String {
        val isBeside = columns >= label + LEAST_TEXT
        val indent = " ".repeat(if (isBeside) label else BELOW)
        return rows.flatMap { (name, text) ->
            val lines = wrapped(text, columns - indent.length).map { indent + it }
            when {
                name.isEmpty() -> lines
                isBeside -> listOf(name.padEnd(label) + lines[0].drop(label)) + lines.drop(1)
                else -> listOf(name) + lines
            }
        }.joinToString("\n") { it.trimEnd() }
    }

    private companion object {
        const val LABEL = 18
        const val LEAST_TEXT = 30
        const val BELOW = 2
    }
}
