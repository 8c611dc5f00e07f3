package daphnis.app.describe

/** `1 sphere`, `2 spheres`. */
internal fun spheres(count: Int): String = if (count == 1) "1 sphere" else "$count spheres"

/** `1 step`, `2 steps`. */
internal fun counted(number: Long, what: String): String = if (number == 1L) "1 $what" else "$number ${what}s"

/** [text] in lines of at most [columns], broken between words; longer words stand alone. */
internal fun wrapped(text: String, columns: Int): List<String> {
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
