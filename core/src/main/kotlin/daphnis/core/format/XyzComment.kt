package daphnis.core.format

/**
 * The second line of a frame in extended XYZ: `key=value` pairs, as ASE and OVITO write them. Values, and keys too, may
 * stand in quotes, in which `\` takes away the meaning of the next letter; lists may stand in `[]` or `{}`. A key alone
 * is true. `Timestep: 100`, as LAMMPS writes it into plain XYZ, is a pair as well.
 *
 * @param fail refuses the file
 */
internal class XyzComment(private val text: String, private val fail: (String) -> Nothing) {
    private val values = HashMap<String, String>()
    private var at = 0

    init {
        // Whether the pair before was faces in a word of their own.
        var wereFaces = false
        while (true) {
            skip()
            if (at == text.length) break
            val isQuoted = text[at] in QUOTES
            val key = if (isQuoted) quoted() else word { it == '=' || it.isWhitespace() }
            COLON.matchEntire(key)?.takeUnless { isQuoted }?.let { found ->
                val name = found.groupValues[1]
                val form = if (name.equals("pbc", ignoreCase = true)) FORM else "$name=\"ax ay az bx by bz cx cy cz\""
                fail("the comment line has a ':' behind $name; write $form")
            }
            val moment = if (isQuoted) null else MOMENT.matchEntire(key)?.groupValues
            if (moment != null) {
                skip()
                put(moment[1], moment[2].ifEmpty { if (at < text.length) word { it.isWhitespace() } else "" })
                continue
            }
            skip()
            val isPair = at < text.length && text[at] == '='
            if (wereFaces && !isPair && FACE.matches(key)) fail("pbc has several words without quotes; write $FORM")
            val value = if (isPair) value() else "T"
            wereFaces = isPair && key.equals("pbc", ignoreCase = true) && text[at - 1] !in ENDING
            put(key, value)
        }
    }

    private fun put(key: String, value: String) {
        val before = values.put(key.lowercase(), value)
        if (before != null && !isSame(before, value)) {
            fail("'${TextLines.shown(key)}' occurs twice, with other values")
        }
    }

    /** The value of the first of [keys], lower case, that is there. */
    operator fun get(vararg keys: String): String? = keys.firstNotNullOfOrNull { values[it] }

    /** The words of a value, without what marks a list. */
    fun list(vararg keys: String): List<String>? = get(*keys)?.split(SEPARATORS)?.filter { it.isNotEmpty() }

    /** Whether values are the same words, or the same numbers in other digits. */
    private fun isSame(a: String, b: String): Boolean {
        val x = a.toDoubleOrNull()
        return a == b || x != null && x == b.toDoubleOrNull()
    }

    private fun skip() {
        while (at < text.length && (text[at].isWhitespace() || text[at] == ',')) at++
    }

    private fun value(): String {
        val behind = ++at
        while (at < text.length && text[at].isWhitespace()) at++
        // Where the next pair follows at once, the value is empty.
        if (at > behind && PAIR.matchesAt(text, at)) return ""
        return when {
            at == text.length -> ""
            text[at] in QUOTES -> quoted()
            text[at] in OPENING -> bracketed()
            else -> word { it.isWhitespace() }.trimEnd(',')
        }
    }

    private inline fun word(isEnd: (Char) -> Boolean): String {
        val from = at
        // A '=' without a key is taken for a part of a word, so that the end of the line is reached.
        if (text[at] == '=') at++
        while (at < text.length && !isEnd(text[at])) at++
        return text.substring(from, at)
    }

    private fun quoted(): String {
        val quote = text[at++]
        val held = StringBuilder()
        while (at < text.length && text[at] != quote) {
            if (text[at] == '\\' && at + 1 < text.length) at++
            held.append(text[at++])
        }
        if (at == text.length) fail("the comment line has a $quote without its counterpart")
        at++
        return held.toString()
    }

    /** A list, in which there may be others. */
    private fun bracketed(): String {
        val from = at
        var depth = 0
        do {
            if (at == text.length) fail("the comment line has a ${text[from]} without its counterpart")
            val c = text[at++]
            if (c in OPENING) depth++
            if (c in CLOSING) depth--
        } while (depth > 0)
        return text.substring(from, at)
    }

    private companion object {
        const val QUOTES = "\"'"
        const val OPENING = "[{("
        const val CLOSING = "]})"
        val PAIR = Regex("""[^\s="']++\s*+=""")

        const val ENDING = QUOTES + CLOSING
        const val FORM = "pbc=\"T T F\""

        /** One face in a word of its own, which would be taken for a key. */
        val FACE = Regex("""(?i)([tf01]|true|false),?""")

        /** How LAMMPS and i-PI say of which step or time a frame is, without extended XYZ. */
        val MOMENT = Regex("""(?i)(step|timestep|time):(.*)""")

        /** A key that would not be known, with what stands behind it. */
        val COLON = Regex("""(?i)(pbc|lattice):(["'\[{].*)?""")
        val SEPARATORS = Regex("""[\s,;\[\]{}()"']+""")
    }
}
