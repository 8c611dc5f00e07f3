package daphnis.app

import java.nio.file.Files
import java.nio.file.Path

/** [base], or the first of base-2, base-3, … that does not exist. */
internal fun freeDirectory(base: Path): Path {
    val name = "${base.fileName}"
    return generateSequence(1) { it + 1 }.map { if (it == 1) base else base.resolveSibling("$name-$it") }
        .first { !Files.exists(it) }
}
