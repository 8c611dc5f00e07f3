package daphnis.app

import com.github.ajalt.mordant.terminal.Terminal
import daphnis.analysis.sweep.SweepRun
import daphnis.app.printing.Overwritten
import daphnis.app.printing.warn
import daphnis.app.progress.columnsFor
import daphnis.app.sweep.PlannedRun
import daphnis.app.sweep.SweepLine
import daphnis.app.sweep.SweepTeller
import java.util.concurrent.ConcurrentHashMap

/**
 * Progress of the whole of a sweep of [all] runs, on the error stream: one line that rewrites itself on a terminal;
 * elsewhere a plain line at the end of each run, and now and then between. Threads of all runs tell it.
 */
internal class SweepProgress(private val quiet: Boolean, private val all: Int) : SweepTeller {
    private val terminal = Terminal()
    private val live = !quiet && terminal.terminalInfo.outputInteractive
    private val interval = if (live) LIVE_NANOSECONDS else PLAIN_NANOSECONDS
    private val begin = System.nanoTime()
    private val parts = ConcurrentHashMap<String, Double>()
    private val notices = HashSet<String>()
    private var credit = 0.0
    private var finished = 0
    private var failed = 0
    private val taken = HashSet<String>()
    private var running = 0
    private var width = 0

    @Volatile
    private var shownAt = begin

    /** [run] begins, or goes on. */
    @Synchronized
    fun begun(run: PlannedRun) {
        running++
        parts.remove(run.name)
    }

    override fun at(name: String, fraction: Double) {
        if (parts.put(name, fraction) == null) earlier(fraction)
        if (!quiet && isDue()) showIfDue()
    }

    private fun isDue() = System.nanoTime() - shownAt > interval

    /** Of the threads that find it due together, one shows it. */
    @Synchronized
    private fun showIfDue() {
        if (isDue()) show()
    }

    /** What had been done of a run before is not counted into the speed. */
    @Synchronized
    private fun earlier(fraction: Double) {
        credit += fraction
    }

    /** A notice that many runs have is said once. */
    @Synchronized
    override fun notice(name: String, line: String) {
        // A run names itself, which is the difference between the notices of two runs.
        if (!notices.add(line.replace(name, ""))) return
        clear()
        warn("$name: $line")
    }

    /** How many other processes have taken. */
    @get:Synchronized
    val busy: Int get() = taken.size

    @Synchronized
    override fun busy(name: String) {
        taken += name
    }

    /** [run] is over: it has a [result], or was interrupted. */
    @Synchronized
    fun ended(run: PlannedRun, result: SweepRun?) {
        running--
        if (result == null) return
        parts[run.name] = 1.0
        val how = if (result.failure == null) {
            "done"
        } else if (run.name in taken) {
            "busy"
        } else {
            "failed"
        }
        if (how == "done") {
            finished++
        } else if (how == "failed") {
            failed++
        }
        if (quiet) return
        if (live) return show()
        warn("${run.name}: $how; ${line().text(Int.MAX_VALUE).trim()}")
        shownAt = System.nanoTime()
    }

    @Synchronized
    private fun show() {
        shownAt = System.nanoTime()
        if (!live) return warn(line().text(Int.MAX_VALUE).trim())
        val columns = columnsFor(terminal)
        val text = line().text(columns)
        Overwritten.ERRORS.show(text, width, columns)
        width = text.length
    }

    private fun line(): SweepLine {
        val done = parts.values.sum()
        val seconds = (System.nanoTime() - begin) * NANO
        val left = if (done - credit > ENOUGH * all) seconds * (all - done) / (done - credit) else Double.NaN
        return SweepLine(finished, failed, busy, if (live) running else 0, all, done / all, left)
    }

    /** Leaves an empty line to write on. */
    @Synchronized
    fun clear() {
        if (live && width > 0) Overwritten.ERRORS.clear(width, columnsFor(terminal))
        width = 0
    }

    private companion object {
        const val LIVE_NANOSECONDS = 200_000_000L
        const val PLAIN_NANOSECONDS = 5_000_000_000L
        const val NANO = 1e-9

        /** Part of the whole from which the time left can be told. */
        const val ENOUGH = 0.02
    }
}
