package daphnis.core

import java.nio.file.Files
import java.nio.file.Path

/** Files of the repository, for tests that hold docs and builds against the code. */
object Repository {
    val root: Path = generateSequence(Path.of("").toAbsolutePath()) { it.parent }
        .first { Files.exists(it.resolve("settings.gradle.kts")) }

    fun read(path: String): String = Files.readString(root.resolve(path))
}
