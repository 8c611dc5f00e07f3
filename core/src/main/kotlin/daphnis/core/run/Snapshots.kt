package daphnis.core.run

import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.format.H5md
import daphnis.core.format.Snapshot

/** `snapshots/`: the state every [every] steps, 0 for never, and at the end. */
internal class Snapshots(private val every: Int, private val directory: RunDirectory) : Output {
    private var lastWritten = -1L

    override fun write(simulation: Simulation) {
        if (isDue(every, simulation.step)) writeState(simulation)
    }

    /** A run that had ended before and is resumed writes its last state again. */
    override fun finish(simulation: Simulation) {
        if (lastWritten != simulation.step) writeState(simulation)
    }

    private fun writeState(simulation: Simulation) {
        val state = Snapshot.of(simulation.population, simulation.boundary, simulation.step, simulation.time)
        val path = directory.snapshot(simulation.step)
        directory.files.writeAtomically(path) { H5md.write(listOf(state), it, Version.text) }
        lastWritten = simulation.step
    }
}
