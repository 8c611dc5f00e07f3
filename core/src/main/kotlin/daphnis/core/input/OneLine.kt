@file:JvmName("Messages")

package daphnis.core.input

import java.util.Locale

/**
 * [text] with line ends written as `\n`. Other control characters, and marks that change the direction of writing, are
 * written as `\u` and their number.
 */
public fun oneLine(text: String): String = OBEYED.replace(text) { match ->
    if (match.value == "\n") "\\n" else match.value.map { "\\u%04x".format(Locale.ROOT, it.code) }.joinToString("")
}

private val OBEYED = Regex("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}]")
