package daphnis.app.progress

import com.github.ajalt.mordant.terminal.Terminal
import daphnis.app.printing.Overwritten
import daphnis.app.printing.warn
import daphnis.core.initial.PlacementProgress
import daphnis.core.initial.PlacementWatcher
import java.util.Locale

/** How far a placement that takes long has come: one line that is written over on a terminal, else one now and then. */
internal class PlacementLine : PlacementWatcher {
    private val terminal = Terminal()
    private val onTerminal = System.console() != null
    private val every = if (onTerminal) LIVE_NANOSECONDS else PLAIN_NANOSECONDS
    private var last = System.nanoTime()
    private var width = 0

    override fun at(part: Double, what: String) {
        val now = System.nanoTime()
        if (now - last < every) return
        last = now
        val text = if (part.isNaN()) what else "%d %%  %s".format(Locale.ROOT, (100 * part).toInt(), what)
        if (!onTerminal) return warn(text)
        Overwritten.ERRORS.show(text, width, columnsFor(terminal))
        width = text.length
    }

    /** Nothing more comes. */
    fun end() {
        if (width > 0) Overwritten.ERRORS.clear(width, columnsFor(terminal))
        width = 0
    }

    companion object {
        private const val LIVE_NANOSECONDS = 200_000_000L
        private const val PLAIN_NANOSECONDS = 5_000_000_000L

        /** What [make] makes, with such a line unless [quiet]. */
        fun <T> shown(quiet: Boolean, make: () -> T): T {
            if (quiet) return make()
            val line = PlacementLine()
            try {
                return PlacementProgress.watched(line) { make() }
            } finally {
                line.end()
            }
        }
    }
}
