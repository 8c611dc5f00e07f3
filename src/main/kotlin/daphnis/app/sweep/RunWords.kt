package daphnis.app.sweep

import daphnis.core.input.InputException
import daphnis.core.run.Version
import java.nio.file.Path

/** The `run` command of each run of a sweep, for programs that share out commands. */
internal class RunWords(private val scenario: String, private val engine: String?) {
    /** The command that makes [run] in [directory], as a shell takes it. */
    fun of(run: PlannedRun, directory: Path): String {
        val words = listOf(Version.command, "run", scenario) +
            run.settings.flatMap { listOf("--set", it) } +
            run.seed?.let { listOf("--seed", "$it") }.orEmpty() +
            engine?.let { listOf("--engine", it) }.orEmpty() +
            listOf("--out", "$directory")
        return words.joinToString(" ", transform = ::quoted)
    }

    private fun quoted(word: String): String {
        if (word.any { it.isISOControl() }) {
            throw InputException("--list", null, "has a line for each run, and '$word' is no text of one line")
        }
        return if (word.isNotEmpty() && word.all { it in PLAIN }) word else "'${word.replace("'", "'\\''")}'"
    }

    private companion object {
        val PLAIN = ('a'..'z') + ('A'..'Z') + ('0'..'9') + "-_./=,:+@%".toList()
    }
}
