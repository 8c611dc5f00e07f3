package daphnis.app.pages

/**
 * A command as a shell would start it.
 *
 * @property words the program and its arguments, without quotation marks
 * @property output the file that takes what it prints, or null
 */
internal class ShellCommand(val words: List<String>, val output: String?) {
    override fun toString() = words.joinToString(" ")
}

/**
 * The commands in a block of a page, in their order: of pipes, lists and substitutions each part. A variable has the
 * value that the block gave it, and stays as it is written if it gave none.
 */
internal fun shellCommands(block: String): List<ShellCommand> = ShellReader(block).read()

private class ShellReader(private val text: String) {
    private val commands = ArrayList<ShellCommand>()
    private val values = HashMap<String, String>()
    private val words = ArrayList<String>()
    private var output: String? = null
    private var isTarget = false
    private var word: StringBuilder? = null
    private var at = 0

    fun read(): List<ShellCommand> {
        while (at < text.length) take(text[at++])
        endCommand()
        return commands
    }

    private fun take(c: Char) {
        when (c) {
            '\\' -> if (at < text.length) text[at++].let { if (it != '\n') add("$it") }
            '\'' -> add(until('\'').also { at++ })
            '"' -> add(known(until('"')).also { at++ })
            ' ', '\t' -> endWord()
            '\n', ';', '|', '&', '(', ')' -> if (c == '&' && isTarget) add("&") else endCommand()
            '>', '<' -> redirect()
            '#' -> if (word == null) at = text.indexOf('\n', at).let { if (it < 0) text.length else it } else add("#")
            '$' -> variable()
            else -> add("$c")
        }
    }

    private fun add(part: String) {
        word = (word ?: StringBuilder()).append(part)
    }

    /** What stands before [quote], at which the reader then is. */
    private fun until(quote: Char): String {
        val end = text.indexOf(quote, at)
        require(end >= 0) { "a quotation mark is not closed: ${text.drop(at - 1).lines().first()}" }
        return text.substring(at, end).also { at = end }
    }

    /** What a program reads from a file is no word of it; the number before `>` is that of a stream. */
    private fun redirect() {
        if (word?.all { it.isDigit() } == true) word = null
        endWord()
        if (at < text.length && text[at] == '(') return
        if (at < text.length && text[at] == '>') at++
        isTarget = true
    }

    private fun variable() {
        val name = NAME.matchAt(text, at)?.value.orEmpty()
        at += name.length
        add(values[name] ?: "$$name")
    }

    private fun known(quoted: String) = VARIABLE.replace(quoted) { values[it.groupValues[1]] ?: it.value }

    private fun endWord() {
        val whole = word?.toString() ?: return
        word = null
        if (!isTarget) {
            words += whole
        } else if (!whole.startsWith("&")) {
            output = whole
        }
        isTarget = false
    }

    private fun endCommand() {
        endWord()
        while (words.isNotEmpty()) {
            val first = words.first()
            val isValue = ASSIGNMENT.containsMatchIn(first)
            if (isValue) values[first.substringBefore('=')] = first.substringAfter('=')
            if (!isValue && first !in KEYWORDS && !PROMPT.matches(first)) break
            words.removeFirst()
        }
        if (words.isNotEmpty()) commands += ShellCommand(words.toList(), output)
        words.clear()
        output = null
    }

    private companion object {
        val NAME = Regex("[A-Za-z_][A-Za-z_0-9]*")
        val VARIABLE = Regex("""\$(\w+)""")
        val ASSIGNMENT = Regex("^[A-Za-z_][A-Za-z_0-9]*=")
        val KEYWORDS = setOf("do", "then", "else", "time", "exec", "!")

        /** What a shell on the machine `a` asks with: `a$`. */
        val PROMPT = Regex("""\w*\$""")
    }
}
