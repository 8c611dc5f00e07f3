package daphnis.core.format

import java.util.Locale

/**
 * A file does not hold what its format promises. The message is one line that names the file and what is wrong;
 * characters of a file or its name that a terminal would obey are written out.
 */
public class FormatException(message: String) : RuntimeException(oneLine(message))

/**
 * [text] with line ends written as `\n`, and other control characters, and marks that turn the direction of writing, as
 * `\u` and their number.
 */
public fun oneLine(text: String): String = OBEYED.replace(text) { match ->
    if (match.value == "\n") "\\n" else match.value.map { "\\u%04x".format(Locale.ROOT, it.code) }.joinToString("")
}

private val OBEYED = Regex("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}]")
