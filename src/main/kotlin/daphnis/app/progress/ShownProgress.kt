package daphnis.app.progress

import com.github.ajalt.mordant.terminal.Terminal
import daphnis.analysis.report.AnalysisProgress
import daphnis.app.Overwritten
import daphnis.app.warn
import java.util.Locale

/** One line that is written over on a terminal, a line now and then without one. */
internal class ShownProgress : AnalysisProgress {
    private val terminal = Terminal()
    private val onTerminal = System.console() != null
    private var last = 0L

    override fun next(done: Int, all: Int, what: String) {
        val now = System.nanoTime()
        if (onTerminal) {
            val columns = columnsFor(terminal)
            Overwritten.ERRORS.show(
                "%3d %% %-60s".format(Locale.ROOT, 100 * done / all, what).take(columns),
                0,
                columns,
            )
            if (done == all) Overwritten.ERRORS.end()
        } else if (now - last > EVERY_NANOSECONDS && done < all) {
            warn("%d %%  %s".format(Locale.ROOT, 100 * done / all, what))
            last = now
        }
    }

    private companion object {
        const val EVERY_NANOSECONDS = 5_000_000_000L
    }
}
