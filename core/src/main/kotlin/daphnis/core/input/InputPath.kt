@file:JvmName("InputPath")

package daphnis.core.input

import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * The path that a user means by [word].
 *
 * @param source where the word is, for messages; with [key]
 * @throws InputException when no file can have that name here: it holds a NUL, or letters that the locale's encoding
 *   does not have
 */
@JvmOverloads
@JvmName("of")
public fun inputPath(word: String, source: String, key: String? = null): Path = try {
    Path.of(word)
} catch (e: InvalidPathException) {
    val encoding = System.getProperty("sun.jnu.encoding")
    val reason = when {
        '\u0000' in word -> "it holds a NUL character"
        else -> "letters of it are not in $encoding, the locale's encoding; try LC_ALL=C.UTF-8"
    }
    throw InputException(source, key, "'${word.take(MOST_SHOWN)}' cannot be the name of a file here: $reason")
}

private const val MOST_SHOWN = 80
