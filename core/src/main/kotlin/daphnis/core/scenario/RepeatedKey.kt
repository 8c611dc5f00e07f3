package daphnis.core.scenario

/**
 * A key that an object in a JSON text has twice, of which a parser takes the last and says nothing.
 *
 * @property path of the key, as messages call it
 * @property offset of the second in the text
 * @property firstOffset of the first
 */
internal class RepeatedKey private constructor(val path: String, val offset: Int, val firstOffset: Int) {
    /** One pass over a [text] that a parser has accepted, comments and all. */
    private class Scan(private val text: String) {
        /** An object with its keys and their offsets, or a list without. */
        private class Level(val name: String, val keys: HashMap<String, Int>?) {
            var last = ""
            var index = 0

            /** What stands here is called so. */
            fun child() = when {
                keys == null -> "$name[$index]"
                name.isEmpty() -> last
                else -> "$name.$last"
            }
        }

        private val levels = ArrayDeque<Level>()
        private var at = 0
        private var isKey = false

        fun first(): RepeatedKey? {
            while (at < text.length) {
                when (text[at]) {
                    '"' -> string()?.let { return it }
                    '{' -> open(HashMap())
                    '[' -> open(null)
                    '}', ']' -> close()
                    ',' -> next()
                    '/' -> comment()
                    else -> at++
                }
            }
            return null
        }

        private fun open(keys: HashMap<String, Int>?) {
            levels.addLast(Level(levels.lastOrNull()?.child().orEmpty(), keys))
            isKey = keys != null
            at++
        }

        private fun close() {
            levels.removeLastOrNull()
            isKey = false
            at++
        }

        private fun next() {
            levels.lastOrNull()?.let { it.index++ }
            isKey = levels.lastOrNull()?.keys != null
            at++
        }

        private fun comment() {
            val isLine = text.startsWith("//", at)
            val end = text.indexOf(if (isLine) "\n" else "*/", at + 2)
            at = if (end < 0) text.length else end + if (isLine) 1 else 2
        }

        private fun string(): RepeatedKey? {
            val from = at++
            val word = StringBuilder()
            while (at < text.length && text[at] != '"') word.append(if (text[at] == '\\') escaped() else text[at++])
            at++
            if (!isKey) return null
            isKey = false
            val level = levels.last()
            level.last = word.toString()
            val before = level.keys!!.put(level.last, from) ?: return null
            return RepeatedKey(level.child(), from, before)
        }

        private fun escaped(): Char {
            val letter = text.getOrElse(at + 1) { '"' }
            val code = if (letter == 'u' &&
                at + 6 <= text.length
            ) {
                text.substring(at + 2, at + 6).toIntOrNull(16)
            } else {
                null
            }
            at += if (code == null) 2 else 6
            return code?.toChar() ?: ESCAPES[letter] ?: letter
        }
    }

    companion object {
        private val ESCAPES = mapOf('n' to '\n', 't' to '\t', 'r' to '\r', 'b' to '\b', 'f' to '\u000C')

        /** The first in [text], which is JSON; null when there is none. */
        fun find(text: String): RepeatedKey? = Scan(text).first()
    }
}
