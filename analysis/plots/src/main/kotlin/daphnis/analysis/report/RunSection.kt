package daphnis.analysis.report

import daphnis.core.run.Version
import daphnis.core.scenario.OutputSpec
import daphnis.core.scenario.TimeStepSpec
import java.math.BigDecimal
import java.math.MathContext
import java.math.RoundingMode
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
        val isChosen = input.scenario?.timeStep?.isChosen == true
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

        private const val HALF = 0.5

        /** Of a number without its error of rounding. */
        private const val DIGITS = 12

        private val PLAIN = Regex("[A-Za-z0-9_./:@%+=,-]+")

        /** Which run would give an error to those of the [rows] that lack states or time for one; null where none does. */
        fun longer(study: Study, rows: List<NumberRow>): String? {
            val scenario = study.input.scenario?.takeIf { study.input.directory != null } ?: return null
            val longer = rows.mapNotNull { it.unknown?.longer }.maxOrNull() ?: return null
            val until = until(scenario.startTime, longer * ((scenario.until ?: return null) - scenario.startTime))
            val ofTime = if (study.isRing) " (time ${study.time(until.toDouble())})" else ""
            val options = (outputs(study, scenario.output, longer) + "--until $until").joinToString(" ")
            return "A run with $options may be long enough for these errors$ofTime."
        }

        /** What a run that is [longer] by that factor is to write more often to have [ENOUGH] of it. */
        private fun outputs(study: Study, output: OutputSpec, longer: Int): List<String> {
            val steps = study.input.summary?.steps ?: return emptyList()
            val (first, last) = study.input.times.first() to study.input.times.last()
            // Of one state nothing is known of the part of the run that would be averaged.
            val averaged = if (last > first) (last - study.from) / (last - first) else HALF
            val every = (longer * steps * averaged / ENOUGH).toInt().coerceAtLeast(1)
            val told = ArrayList<String>()
            val interval = output.snapshotInterval
            if (interval == null) {
                if (output.snapshotEvery !in 1..every) told += "--set output.snapshotEvery=$every"
            } else if (longer * study.averaged.size < ENOUGH) {
                val shorter = interval * longer * study.averaged.size / ENOUGH
                told += "--set output.snapshotInterval=${typed(shorter, RoundingMode.DOWN)}"
            }
            if (output.transportEvery > every) told += "--set output.transportEvery=$every"
            return told
        }

        /** The time that is [span] after [start], to three digits of the span. */
        fun until(start: Double, span: Double) =
            BigDecimal("$start").add(BigDecimal(typed(span, RoundingMode.UP))).stripTrailingZeros().toPlainString()

        /** [value] to three digits, as it can be typed. */
        private fun typed(value: Double, rounding: RoundingMode) = BigDecimal(value).round(MathContext(DIGITS))
            .round(MathContext(3, rounding)).stripTrailingZeros().toPlainString()

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
