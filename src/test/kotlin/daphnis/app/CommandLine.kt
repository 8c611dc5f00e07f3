package daphnis.app

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path

/** What a command left: exit code, standard output, error stream. */
internal class CommandResult(val code: Int, val out: String, val err: String)

/** Runs the command line in this process. */
internal fun daphnis(vararg args: String): CommandResult {
    val out = ByteArrayOutputStream()
    val err = ByteArrayOutputStream()
    val oldOut = System.out
    val oldErr = System.err
    System.setOut(PrintStream(out, true))
    System.setErr(PrintStream(err, true))
    try {
        return CommandResult(runDaphnis(arrayOf(*args)), out.toString(), err.toString())
    } finally {
        System.setOut(oldOut)
        System.setErr(oldErr)
    }
}

/** Exit code 0; what stands on the output. */
internal fun assertDone(result: CommandResult): String {
    assertEquals(0, result.code) { result.err }
    return result.out
}

/** Exit code 2 and one line on the error stream that holds [parts]. */
internal fun assertRefused(result: CommandResult, vararg parts: String) {
    assertEquals(2, result.code) { result.err }
    assertEquals(1, result.err.trimEnd().lines().size) { result.err }
    for (part in parts) assertTrue(part in result.err) { "'$part' is not in ${result.err}" }
    assertFalse("Exception" in result.err) { result.err }
}

/** [write] replaces [files] by others in one act each, so that a second name of the old ones keeps what they held. */
internal fun assertReplacedWhole(files: List<Path>, write: () -> Unit) {
    val held = files.map { file ->
        Files.createLink(file.resolveSibling("${file.fileName}.held"), Files.writeString(file, "old"))
    }
    write()
    for (file in files) assertTrue(Files.readString(file) != "old") { "$file was not written" }
    for (other in held) assertEquals("old", Files.readString(other)) { "$other" }
}

/** What `describe` says of the scenario [word] with [settings]. */
internal fun describe(word: String, vararg settings: String) = assertDone(
    daphnis(
        "describe",
        word,
        *settings.flatMap {
            listOf("--set", it)
        }.toTypedArray(),
    ),
)

/** The row with [label], continued rows joined. */
internal fun row(text: String, label: String): String {
    val lines = text.lines()
    val at = lines.indexOfFirst { it.startsWith(label.padEnd(18)) }
    assertTrue(at >= 0) { "no $label in\n$text" }
    val continued = lines.drop(at + 1).takeWhile { it.startsWith(" ") }
    return (listOf(lines[at]) + continued).joinToString("\n") { it.drop(18) }
}
