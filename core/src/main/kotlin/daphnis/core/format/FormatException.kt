@file:JvmName("Messages")

package daphnis.core.format

import java.util.Locale

/**
 * Thrown when a file does not agree with its format. The message is one line that names the file and what is wrong.
 * Control characters of a file or its name, on which a terminal would act, are written out.
 */
public class FormatException(message: String) : RuntimeException(oneLine(message))

/**
 * [text] with line ends written as `\n`. Other control characters, and marks that change the direction of writing, are
 * written as `\u` and their number.
 */
public fun oneLine(text: String): String = OBEYED.replace(text) { match ->
    if (match.value == "\n") "\\n" else match.value.map { "\\u%04x".format(Locale.ROOT, it.code) }.joinToString("")
}

private val OBEYED = Regex("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}]")
