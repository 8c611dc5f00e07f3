package daphnis.analysis.sweep

import daphnis.analysis.report.ReportNumber
import daphnis.analysis.report.ReportText
import daphnis.analysis.statistics.SampleMean
import daphnis.analysis.statistics.Steadiness
import daphnis.analysis.table.UnitNames
import daphnis.core.input.oneLine
import java.util.Locale

/** The numbers of a [sweep] to be read: tables in Markdown, a row for each quantity and a column for each point. */
public class SweepText(private val sweep: Sweep) {
    /** What is zero in all runs, as the potential energy without forces, tells nothing. */
    private val zero = sweep.quantities.filter { q ->
        sweep.runs.all { run -> run.numbers.none { it.key == q.key && it.value != 0.0 } }
    }
    private val quantities = sweep.quantities - zero.toSet()
    private val names = quantities.map { named(it) }
    private val most = sweep.points.maxOfOrNull { it.runs.size } ?: 0

    /** In tables beside as many points as fit in [columns], one at least; then what ± is, and which runs failed. */
    public fun text(columns: Int): String {
        val parts = ArrayList<String>()
        if (quantities.isNotEmpty()) {
            val shown = sweep.points.map { listOf(label(it)) + quantities.map { q -> cell(it, q) } }
            for (block in blocks(shown, columns)) parts += table(listOf(listOf(corner()) + names) + block)
        }
        val notes = listOfNotNull(meaning(), zeros(), unsteady(), unjudged()) + incomplete() + failures()
        if (notes.isNotEmpty()) parts += notes.joinToString("\n")
        return parts.joinToString("\n\n")
    }

    private fun corner() = if (sweep.keys.size == 1) oneLine(sweep.keys[0]) else "quantity"

    private fun label(point: Sweep.Point): String = when (sweep.keys.size) {
        0 -> "mean"
        1 -> oneLine(point.values[0])
        else -> sweep.keys.indices.joinToString(", ") {
            oneLine("${sweep.keys[it].substringAfterLast('.')}=${point.values[it]}")
        }
    }

    private fun named(q: ReportNumber) = if (q.unit.isEmpty()) q.name else "${q.name}, ${UnitNames.raised(q.unit)}"

    /** The number of runs stands where it is another than that of most cells. */
    private fun cell(point: Sweep.Point, q: ReportNumber): String {
        val m = point.mean(q.key)
        if (m.count == 0) return "–"
        val mark = if (point.unsteady(q.key) > 0) {
            MARK
        } else if (point.unjudged(q.key) > 0) {
            UNJUDGED_MARK
        } else {
            ""
        }
        val text = ReportText.withError(m.mean, m.error) + mark
        return if (m.count == most) text else "$text (n = ${m.count})"
    }

    private fun blocks(points: List<List<String>>, columns: Int): List<List<List<String>>> {
        fun width(cells: List<String>) = cells.maxOf { it.length } + BETWEEN
        val first = width(listOf(corner()) + names) + 1
        val blocks = ArrayList<ArrayList<List<String>>>()
        var used = 0
        for (cells in points) {
            if (blocks.isEmpty() || used + width(cells) > columns) {
                blocks += ArrayList<List<String>>()
                used = first
            }
            blocks.last() += cells
            used += width(cells)
        }
        return blocks
    }

    /** Columns padded to one width, the first to the left. */
    private fun table(columns: List<List<String>>): String {
        val widths = columns.map { cells -> cells.maxOf { it.length } }
        val lines = columns[0].indices.map { row ->
            columns.indices.joinToString(" | ", "| ", " |") {
                val cell = columns[it][row].replace('|', '/')
                if (it == 0) cell.padEnd(widths[0]) else cell.padStart(widths[it])
            }
        }
        val rule = widths.indices.joinToString("|", "|", "|") {
            "-".repeat(widths[it] + 1) + if (it == 0) "-" else ":"
        }
        return (listOf(lines[0], rule) + lines.drop(1)).joinToString("\n")
    }

    private fun meaning(): String? {
        if (most < 2 || quantities.isEmpty()) return null
        val least = sweep.points.flatMap { p -> quantities.map { p.mean(it.key).count } }.filter { it >= 2 }.minOrNull()
        val fewer = if (least == null || least == most) "" else ", and in ${coverage(least)} with n = $least"
        return "n = $most runs that differ in their seed; ± is one standard error of their mean, " +
            "which covers the true mean in ${coverage(most)} of cases$fewer."
    }

    private fun coverage(n: Int) = String.format(Locale.ROOT, "%.0f %%", 100 * SampleMean.coverage(n))

    private fun zeros() = if (zero.isEmpty()) null else "0 in all runs: ${zero.joinToString { it.name }}."

    private fun unsteady(): String? {
        val drifting = sweep.runs.count { it.failure == null && !it.isSteady }
        if (drifting == 0) return null
        return "!: ${SweepRun.UNSTEADY}, in $drifting of ${ReportText.count(sweep.runs.size, "run")}; " +
            "the means of these runs may all be too large, or all too small."
    }

    private fun unjudged(): String? {
        val short = sweep.runs.count { it.failure == null && !it.isJudged }
        if (short == 0) return null
        return "?: ${SweepRun.UNJUDGED}, in $short of ${ReportText.count(sweep.runs.size, "run")}; " +
            "it takes ${Steadiness.FEWEST} in each (output.seriesEvery or transportEvery)."
    }

    /** Remarks on runs that are finished, each once. */
    private fun incomplete(): List<String> =
        sweep.runs.filter { it.failure == null && it.remark != null }.groupBy { it.remark }.map { (remark, runs) ->
            oneLine("${ReportText.count(runs.size, "run")}: $remark")
        }

    private fun failures(): List<String> = sweep.failed.map { oneLine("failed: ${it.name}: ${it.failure}") }

    private companion object {
        /** Characters between columns. */
        const val BETWEEN = 3

        /** Behind a mean over runs of which one at least is not steady. */
        const val MARK = " !"

        /** Behind one over runs of which none is seen to drift, but one at least has too few rows to tell. */
        const val UNJUDGED_MARK = " ?"
    }
}
