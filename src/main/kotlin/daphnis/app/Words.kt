package daphnis.app

import daphnis.core.input.InputException
import daphnis.core.input.inputPath
import java.nio.file.Files
import java.nio.file.Path

/**
 * The path that [word] of the command line means. An empty one, as of a variable that is not set, would mean the
 * working directory, which is never wanted.
 *
 * @param what the option or argument
 */
internal fun pathOf(word: String, what: String): Path {
    if (word.isEmpty()) throw InputException(what, null, "is empty; a name is needed")
    return inputPath(word, what)
}

/** The same of a file to write, whose directory must be there: a path with a slip in it would else make folders. */
internal fun newFileOf(word: String, what: String): Path = pathOf(word, what).also {
    val directory = it.toAbsolutePath().parent
    if (!Files.isDirectory(directory)) throw InputException(what, null, "is $word; there is no directory $directory")
}
