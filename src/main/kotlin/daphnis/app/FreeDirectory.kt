package daphnis.app

import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

/** [base], or the first of base-2, base-3, … that does not exist. */
internal fun freeDirectory(base: Path): Path {
    val name = "${base.fileName}"
    return generateSequence(1) { it + 1 }.map { if (it == 1) base else base.resolveSibling("$name-$it") }
        .first { !Files.exists(it) }
}

/** A name for a directory that is made of [name], of a scenario. */
internal fun directoryName(name: String): String {
    val letters = name.map { if (isNameable(it)) it else '-' }.joinToString("")
    return letters.trim('.').take(LONGEST_NAME).ifEmpty { "run" }
}

/** Letters beyond ASCII only where the file system takes them, which depends on the locale. */
private fun isNameable(c: Char): Boolean = try {
    c in "-_." || (c.isLetterOrDigit() && Path.of("$c").toString() == "$c")
} catch (e: InvalidPathException) {
    false
}

private const val LONGEST_NAME = 80
