package daphnis.app

import com.github.ajalt.clikt.core.ProgramResult
import daphnis.analysis.sweep.Sweep
import daphnis.analysis.sweep.SweepPlots
import daphnis.analysis.sweep.SweepRun
import daphnis.analysis.sweep.SweepTables
import daphnis.analysis.sweep.SweepText
import daphnis.app.printing.printLine
import daphnis.app.printing.printLines
import daphnis.app.printing.warn
import daphnis.app.sweep.SweepOrder
import daphnis.core.format.WholeFile

/** Prints what has come of the runs of a sweep, and writes its tables and plots. */
internal class SweepReport(private val order: SweepOrder, private val quiet: Boolean) {
    private val place = order.place

    /** Writes tables and plots of [done] runs, and calls [tell] with what a user should know of them. */
    fun write(done: List<SweepRun>, tell: (String) -> Unit) {
        write(sweepOf(done), tell)
    }

    private fun sweepOf(done: List<SweepRun>): Sweep {
        val keys = order.plan.varying.map { it.path }
        return Sweep(keys, done, keys.map { order.label.of(it) })
    }

    /** @return the number of plots */
    private fun write(sweep: Sweep, tell: (String) -> Unit): Int = writing(place.path) {
        val tables = SweepTables(sweep)
        tables.writeMeans(place.means)
        tables.writeRuns(place.runs)
        WholeFile.write(place.text, "# ${order.title}\n\n${SweepText(sweep).text(WIDE)}\n")
        val drawn = SweepPlots(sweep)
        drawn.write(place.plots).also {
            drawn.missing?.let { why -> tell("there are no PNG pictures in ${place.plots}, only SVG: $why") }
        }
    }

    /** Makes tables and plots of [done] runs, of which some may be [busy]. @throws ProgramResult when some failed */
    fun conclude(done: List<SweepRun>, busy: Int = 0) {
        val sweep = sweepOf(done)
        printLines(table(SweepText(sweep)))
        val plots = write(sweep, ::warn)
        if (!quiet) {
            printLine("")
            printLine("${if (plots == 0) "tables" else "tables and plots"} are in ${place.path}")
        }
        requireNoneFailed(done, busy) { "see ${place.runs}" }
    }

    /** Says how [done] runs of a [part] of the sweep have ended. @throws ProgramResult when some failed */
    fun concludePart(part: String, done: List<SweepRun>, busy: Int) {
        for (run in done) run.failure?.let { warn("${run.name}: $it") }
        if (!quiet) {
            val finished = done.count { it.failure == null }
            printLine("$part: $finished of ${done.size} runs are finished; `--collect` makes the tables of all parts")
        }
        requireNoneFailed(done, busy) { "the same command tries them again" }
    }

    private fun requireNoneFailed(done: List<SweepRun>, busy: Int, advice: () -> String) {
        val failed = done.count { it.failure != null }
        if (failed == 0) return
        val how = if (busy == 0) {
            "failed"
        } else if (busy == failed) {
            "busy"
        } else {
            "failed, $busy of them busy"
        }
        throw ProgramResult(complain("$failed of ${done.size} runs $how, ${advice()}", EXIT_FAILED))
    }

    /** Beside each other stand as many points as have place; where not even one has, all are listed below. */
    private fun table(sweep: SweepText): String {
        val columns = outputColumns() ?: return sweep.text(WIDE)
        val text = sweep.text(columns)
        return fitted(if (isWide(text.lines(), columns)) sweep.text(Int.MAX_VALUE) else text, columns)
    }

    private companion object {
        /** Columns of a table where there is no terminal. */
        const val WIDE = 120
    }
}
