@file:JvmName("InputPath")

package daphnis.core.input

import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * The path that a user means by [word].
 *
 * @param source where the word is, for messages; with [key]
 * @throws InputException when no file can have that name here: it holds a NUL, letters that the locale's encoding
 *   does not have, or what Windows forbids
 */
@JvmOverloads
@JvmName("of")
public fun inputPath(word: String, source: String, key: String? = null): Path = try {
    Path.of(word)
} catch (e: InvalidPathException) {
    val reason = reasonOf(e, System.getProperty("sun.jnu.encoding"))
    throw InputException(source, key, "'${word.take(MOST_SHOWN)}' cannot be the name of a file here: $reason")
}

/** Why [e]; names are in the [encoding]. Only Windows has characters that no name may hold. */
internal fun reasonOf(e: InvalidPathException, encoding: String): String {
    val character = e.input.getOrNull(e.index)
    return when {
        '\u0000' in e.input -> "it holds a NUL character"
        character != null && character in FORBIDDEN -> "it holds a $character"
        else -> "letters of it are not in $encoding, the locale's encoding; try LC_ALL=C.UTF-8"
    }
}

private const val FORBIDDEN = "<>:\"|?*"

private const val MOST_SHOWN = 80
