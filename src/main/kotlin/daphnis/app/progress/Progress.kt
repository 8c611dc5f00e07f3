package daphnis.app.progress

import com.github.ajalt.mordant.terminal.Terminal
import daphnis.app.printing.Overwritten
import daphnis.app.printing.printLine
import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.Simulation
import java.util.Locale

/**
 * Progress of a run to time [until]: one line that rewrites itself on a terminal, a plain line now and then elsewhere.
 *
 * @param times in which it tells times
 * @param energyUnit empty where it has no name
 * @param able as [SlowStep] has it
 * @param patience nanoseconds until a step is told of
 */
internal class Progress(
    private val quiet: Boolean,
    private val until: Double,
    private val times: TimesInWords,
    private val energyUnit: String,
    able: () -> Long,
    patience: Long = PATIENCE,
) : Output {
    private val terminal = Terminal()
    private val live = !quiet && terminal.terminalInfo.outputInteractive
    private val interval = if (live) LIVE_SECONDS else PLAIN_SECONDS
    private var pace = Pace(until)
    private var shownAt = 0.0
    private var isFirst = true
    private var collisionsBefore = 0L
    private var width = 0
    private val slow = SlowStep(patience, able, ::tellSlow)
    private lateinit var simulation: Simulation

    override fun open(simulation: Simulation, opening: Opening) {
        this.simulation = simulation
        pace = Pace(until)
    }

    /** The next step begins. */
    fun beginStep() {
        if (!quiet) slow.begin(simulation.step + 1)
    }

    override fun write(simulation: Simulation) {
        if (quiet || simulation.step == 0L) return
        val wallSeconds = pace.seconds()
        val collisions = simulation.collisions?.counters?.collisions ?: 0
        val left = pace.left(simulation.time)
        if (isFirst) {
            isFirst = false
            shownAt = wallSeconds
            collisionsBefore = collisions
            return
        }
        if (wallSeconds - shownAt < interval) return
        val rate = (collisions - collisionsBefore) / (wallSeconds - shownAt)
        val energy = simulation.conserved().kineticEnergy
        val size = times.size
        val (start, now, end) = listOf(simulation.runStart / size, simulation.time / size, until / size)
        show(ProgressLine(start, now, end, simulation.step, left, rate, energy, times.shortUnit, energyUnit))
        shownAt = wallSeconds
        collisionsBefore = collisions
    }

    private fun tellSlow(step: Long, seconds: Double) {
        // What follows a step, such as a checkpoint, is none of it.
        if (simulation.step >= step) return
        aside("step $step has taken %.0f s so far; a shorter timeStep makes shorter steps".format(Locale.ROOT, seconds))
    }

    /** A line that stays, from any thread. */
    @Synchronized
    private fun aside(text: String) {
        clear()
        printLine(text)
    }

    private fun clear() {
        if (width > 0) Overwritten.OUTPUT.clear(width, columnsFor(terminal))
        width = 0
    }

    @Synchronized
    private fun show(line: ProgressLine) {
        if (!live) {
            printLine(line.text(Int.MAX_VALUE))
            return
        }
        val columns = columnsFor(terminal)
        val text = line.text(columns)
        Overwritten.OUTPUT.show(text, width, columns)
        width = text.length
    }

    override fun finish(simulation: Simulation): Unit = slow.end()

    override fun close() {
        slow.end()
        clear()
    }

    private companion object {
        const val LIVE_SECONDS = 0.2
        const val PLAIN_SECONDS = 5.0

        /** Nanoseconds. */
        const val PATIENCE = 30_000_000_000
    }
}
