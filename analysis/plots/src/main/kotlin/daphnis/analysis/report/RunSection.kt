package daphnis.analysis.report

import daphnis.core.run.Version
import daphnis.core.scenario.OutputSpec
import daphnis.core.scenario.TimeStepSpec
import java.math.BigDecimal
import java.math.MathContext
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
        /** States that are enough for most errors. */
        private const val ENOUGH = 40

        private val PLAIN = Regex("[A-Za-z0-9_./:@%+=,-]+")

        /** Which run would give an error to those of the [rows] that lack states or time for one; null where none does. */
        fun longer(study: Study, rows: List<NumberRow>): String? {
            val scenario = study.input.scenario?.takeIf { study.input.directory != null } ?: return null
            val longer = rows.mapNotNull { it.unknown?.longer }.maxOrNull() ?: return null
            val end = scenario.until ?: return null
            val later = "--until ${typed(end + (longer - 1) * (end - scenario.startTime))}"
            val options = listOfNotNull(states(study, scenario.output, longer), later).joinToString(" ")
            return "A run with $options should be long enough for these errors."
        }

        /** How often a run that is [longer] by that factor is to write states; null where it has enough. */
        private fun states(study: Study, output: OutputSpec, longer: Int): String? {
            val fewer = ENOUGH.toDouble() / (longer * study.averaged.size)
            val interval = output.snapshotInterval
            return when {
                fewer <= 1 -> null
                interval != null -> "--set output.snapshotInterval=${typed(interval / fewer)}"
                output.snapshotEvery > 0 ->
                    "--set output.snapshotEvery=${(output.snapshotEvery / fewer).toInt().coerceAtLeast(1)}"
                else -> null
            }
        }

        /** [value] as it can be typed. */
        private fun typed(value: Double) = BigDecimal(value).round(MathContext(3)).stripTrailingZeros().toPlainString()

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
