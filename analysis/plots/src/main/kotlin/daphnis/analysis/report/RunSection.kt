package daphnis.analysis.report

import daphnis.core.run.Version
import daphnis.core.scenario.TimeStepSpec
import java.nio.file.Files
import java.nio.file.Path

/** What was run, and the commands that do it again. */
internal class RunSection(private val study: Study) : Section {
    private val input = study.input

    override val heading = "Run"
    override val over = if (input.directory == null) "What is known of the states." else "What was run, and with what."

    override fun write(page: ReportPage) {
        page.parameters(RunParameters(input, study.last).rows())
        val directory = input.directory ?: return
        if (Files.exists(directory.program)) return
        val run = directory.path
        // A step ends where a run was to end first.
        val isChosen = input.scenario?.timeStep is TimeStepSpec.Automatic
        val unless = if (isChosen) ", unless the run was resumed to another end than it had at first" else ""
        // Of a run without a summary nobody knows.
        val what = if (input.summary?.finished == true) {
            "it gives the same state digest on any machine, with any engine and number of threads$unless"
        } else {
            "it goes on beyond this run, which did not reach the end of its scenario (daphnis resume goes on with it)"
        }
        page.paragraph(
            "To do it again, from the directory in which this report was made: the scenario as it was resolved is in " +
                "the run directory; $what.",
        )
        val again = quoted(besides(run))
        val daphnis = quoted(Path.of(Version.command))
        page.commands(
            listOf(
                "$daphnis run ${quoted(run.resolve("scenario.json"))} --out $again",
                "$daphnis compare ${quoted(run)} $again",
                "$daphnis analyze $again",
            ),
        )
    }

    companion object {
        private val PLAIN = Regex("[A-Za-z0-9_./:@%+=,-]+")

        /** A directory beside [run], which may be given as `.` and has no name of its own then. */
        fun besides(run: Path): Path {
            val name = run.fileName?.toString().orEmpty()
            return if (name.isEmpty() || name == "." || name == "..") {
                Path.of("again")
            } else {
                run.resolveSibling("$name-again")
            }
        }

        /** [path] as a shell takes it for one word. */
        fun quoted(path: Path): String {
            val word = path.toString()
            return if (PLAIN.matches(word)) word else "'${word.replace("'", "'\\''")}'"
        }
    }
}
