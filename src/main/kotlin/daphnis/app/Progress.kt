package daphnis.app

import com.github.ajalt.mordant.terminal.Terminal
import daphnis.core.Simulation
import daphnis.core.population.Conserved
import daphnis.core.run.RunObserver
import java.util.Locale

/** Progress of a run: one line that rewrites itself on a terminal, a plain line now and then elsewhere. */
internal class Progress(private val quiet: Boolean) :
    RunObserver,
    AutoCloseable {
    private val live = !quiet && Terminal().terminalInfo.outputInteractive
    private val interval = if (live) LIVE_SECONDS else PLAIN_SECONDS
    private var shownAt = 0.0
    private var firstTime = Double.NaN
    private var collisionsBefore = 0L
    private var width = 0

    override fun afterStep(simulation: Simulation, until: Double, wallSeconds: Double) {
        if (quiet) return
        val collisions = simulation.collisions?.counters?.collisions ?: 0
        if (firstTime.isNaN()) {
            firstTime = simulation.time
            shownAt = wallSeconds
            collisionsBefore = collisions
            return
        }
        if (wallSeconds - shownAt < interval) return
        val left = wallSeconds * (until - simulation.time) / (simulation.time - firstTime)
        val rate = (collisions - collisionsBefore) / (wallSeconds - shownAt)
        val line = String.format(
            Locale.ROOT,
            "%3.0f %%  step %d  time %.4g of %.4g  %s left  %.3g collisions/s  energy %.5g",
            100 * (simulation.time - simulation.runStart) / (until - simulation.runStart),
            simulation.step,
            simulation.time,
            until,
            clock(left),
            rate,
            Conserved.of(simulation.population).kineticEnergy,
        )
        show(line)
        shownAt = wallSeconds
        collisionsBefore = collisions
    }

    private fun show(line: String) {
        if (!live) {
            println(line)
            return
        }
        print("\r" + line.padEnd(width))
        System.out.flush()
        width = line.length
    }

    private fun clock(seconds: Double): String {
        val s = if (seconds.isFinite()) Math.round(maxOf(0.0, seconds)) else 0
        return if (s >= 3600) "%d:%02d:%02d".format(Locale.ROOT, s / 3600, s / 60 % 60, s % 60) else "%d:%02d".format(Locale.ROOT, s / 60, s % 60)
    }

    override fun close() {
        if (live && width > 0) print("\r" + " ".repeat(width) + "\r")
    }

    private companion object {
        const val LIVE_SECONDS = 0.2
        const val PLAIN_SECONDS = 5.0
    }
}
