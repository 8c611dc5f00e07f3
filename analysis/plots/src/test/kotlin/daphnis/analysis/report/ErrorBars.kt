package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.statistics.Steadiness.Verdict
import daphnis.core.run.Run
import daphnis.core.scenario.Scenario
import java.nio.file.Files
import java.nio.file.Path
import java.util.Locale
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Holds the ± of a report against how much its numbers scatter from seed to seed: what many short runs of one scenario
 * come to, each with the ± that its own report gives.
 *
 * @param options of these reports
 */
internal class ErrorBars(private val options: AnalysisOptions = AnalysisOptions()) {
    private val numbers = LinkedHashMap<String, ArrayList<NumberRow>>()

    private val histories = LinkedHashMap<String, ArrayList<History>>()

    /** Runs so far. */
    var runs = 0
        private set

    /** Of these, which have no ± since they are not steady. */
    var unsteady = 0
        private set

    /** Runs [scenario] with [seed] in [home], unless it was, and takes in what its report says. */
    fun add(scenario: Scenario, seed: Long, home: Path) {
        if (!Files.exists(home.resolve("summary.json"))) {
            Run.start(scenario.copy(seed = seed), "$home", home).use { it.execute() }
        }
        add(AnalysisInput.ofRun(home))
    }

    private fun add(input: AnalysisInput) {
        val from = input.times.first() + USUAL * (input.times.last() - input.times.first())
        for (h in RunHistory.of(input, from)) {
            val late = h.first(from) until h.times.size
            val averaged = History(h.name, h.times.sliceArray(late), h.values.sliceArray(late))
            histories.getOrPut(h.name) { ArrayList() } += averaged
        }
        val rows = Analysis(input, options).rows()
        runs++
        if (rows.any { it.unknown == Unknown.UNSTEADY }) unsteady++
        for (row in rows) {
            if (row.isAverage ||
                row.isOfChange
            ) {
                numbers.getOrPut(row.key ?: row.name) { ArrayList() } += row
            }
        }
    }

    /**
     * @property covered part of the ± that reach to the mean over all runs
     * @property spread standard deviation of the values over the root mean square of the ±
     * @property given values with ±
     */
    class Line(val name: String, val covered: Double, val spread: Double, val given: Int)

    /** By number; those with fewer than ten ± are left out, and those that are the same in every run. */
    fun lines(): List<Line> = numbers.mapNotNull { (name, rows) ->
        val mean = rows.map { it.value }.average()
        val given = rows.filter { !it.error.isNaN() }
        if (given.size < FEWEST) return@mapNotNull null
        if (rows.all { abs(it.value - mean) <= CONSERVED * abs(mean) }) return@mapNotNull null
        val deviation = given.sumOf { (it.value - mean) * (it.value - mean) } * rows.size / (rows.size - 1)
        val spread = sqrt(deviation / given.sumOf { it.error * it.error })
        Line(name, given.count { abs(it.value - mean) <= it.error } / given.size.toDouble(), spread, given.size)
    }

    /** The lines as a table of Markdown. */
    fun table(): String = buildString {
        append("| quantity | covered | spread/± | with ± |\n|---|---|---|---|\n")
        for (line in this@ErrorBars.lines()) {
            val numbers = "%.0f %% | %.2f | %d".format(Locale.ROOT, 100 * line.covered, line.spread, line.given)
            append("| ${line.name} | $numbers |\n")
        }
    }

    /** By main quantity, in how many runs a drift of each of [DRIFTS] standard errors of its average is found. */
    fun drifts(): Map<String, List<Int>> = histories.mapValues { (_, all) ->
        val means = all.map { it.values.average() }
        val error = sqrt(means.sumOf { (it - means.average()) * (it - means.average()) } / (means.size - 1))
        DRIFTS.map { errors -> all.count { isFound(it, errors * error) } }
    }

    private fun isFound(h: History, change: Double): Boolean {
        val drifting = DoubleArray(h.values.size) { h.values[it] + change * it / (h.values.size - 1) }
        return History(h.name, h.times, drifting).steadiness(h.times[0]).verdict == Verdict.DRIFTING
    }

    /** The same as a table of Markdown. */
    fun driftTable(): String = buildString {
        append("| drift of | ${DRIFTS.joinToString(" | ")} standard errors |\n|${"---|".repeat(DRIFTS.size + 1)}\n")
        for ((name, found) in drifts()) append("| $name | ${found.joinToString(" | ")} |\n")
    }

    companion object {
        val DRIFTS = listOf(0, 3, 5, 10, 15, 20)

        /** Where averages begin unless the run drifts. */
        private const val USUAL = 0.375
        private const val FEWEST = 10

        /** Scatter of what is conserved, as a part of it. */
        private const val CONSERVED = 1e-9
    }
}
