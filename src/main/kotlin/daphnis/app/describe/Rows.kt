package daphnis.app.describe

/** A description as rows of a label and a text; a label that is repeated is left out. */
internal class Rows {
    private val rows = ArrayList<Pair<String, String>>()
    private var last = ""

    fun add(label: String, text: String) {
        rows += (if (label == last) "" else label) to text
        last = label
    }

    /**
     * The rows in lines of at most [columns], broken between words; longer words stand alone. Texts stand beside their
     * labels, and where that leaves too little for them, below.
     */
    fun text(columns: Int = Int.MAX_VALUE): String {
        val isBeside = columns >= LABEL + LEAST_TEXT
        val indent = " ".repeat(if (isBeside) LABEL else BELOW)
        return rows.flatMap { (label, text) ->
            val lines = text.lines().flatMap { wrapped(it, columns - indent.length) }.map { indent + it }
            when {
                label.isEmpty() -> lines
                isBeside -> listOf(label.padEnd(LABEL) + lines[0].drop(LABEL)) + lines.drop(1)
                else -> listOf(label) + lines
            }
        }.joinToString("\n") { it.trimEnd() }
    }

    private fun wrapped(text: String, columns: Int): List<String> {
        val lines = arrayListOf("")
        for (word in text.split(' ')) {
            val line = lines.last()
            if (line.isNotEmpty() && line.length + 1 + word.length > columns) {
                lines += word
            } else {
                lines[lines.lastIndex] = if (line.isEmpty()) word else "$line $word"
            }
        }
        return lines
    }

    private companion object {
        const val LABEL = 18
        const val LEAST_TEXT = 30
        const val BELOW = 2
    }
}
