package daphnis.app.sweep

/**
 * The values in the text behind `path=` of a swept setting, which commas divide. A comma inside brackets, braces or
 * quotation marks belongs to the value: `1,2,4` is three values, `[1,2],[4,4]` two, `"a,b"` one.
 */
internal object ValueList {
    /** @throws IllegalArgumentException with what is wrong, as the end of a sentence that begins with the setting */
    fun split(text: String): List<String> {
        val values = ArrayList<String>()
        val open = ArrayDeque<Char>()
        var begin = 0
        var isQuoted = false
        var k = 0
        while (k < text.length) {
            val c = text[k]
            when {
                isQuoted && c == '\\' -> k++
                c == '"' -> isQuoted = !isQuoted
                isQuoted -> Unit
                c in OPENING -> open.addLast(c)
                c in CLOSING -> require(open.removeLastOrNull() == OPENING[CLOSING.indexOf(c)]) {
                    "has a '$c' that closes nothing"
                }
                c == ',' && open.isEmpty() -> {
                    values += text.substring(begin, k).trim()
                    begin = k + 1
                }
            }
            k++
        }
        require(!isQuoted) { "has a quotation mark that is not closed" }
        require(open.isEmpty()) { "has a '${open.last()}' that is not closed" }
        values += text.substring(begin).trim()
        require(values.size == 1 || values.none { it.isEmpty() }) { "has an empty value between two commas" }
        val seen = HashSet<Any>()
        for (value in values) require(seen.add(value.toDoubleOrNull() ?: value)) { "has the value $value twice" }
        return values
    }

    private const val OPENING = "[{"
    private const val CLOSING = "]}"
}
