package daphnis.core.run

import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.format.H5md
import daphnis.core.format.H5mdChecksum
import daphnis.core.format.Snapshot
import daphnis.core.scenario.OutputSpec

/** The declaration of [Snapshots]. The final state is always written. */
internal object SnapshotsOutput :
    PeriodicOutput("snapshots", OutputSpec::snapshotEvery, OutputSpec::snapshotInterval) {
    /** Measured: positions and velocities hardly compress. */
    private const val SPHERE_BYTES = 63.0
    private const val HEAD_BYTES = 3100.0

    override val folder: String get() = RunDirectory.SNAPSHOTS

    override fun cost(times: OutputTimes, course: Course, spheres: Int): OutputCost {
        val count = times.count(course) + if (times.isDueAtEnd(course)) 0 else 1
        return OutputCost("snapshots", count, count * (SPHERE_BYTES * spheres + HEAD_BYTES))
    }

    override fun make(times: OutputTimes, sums: StepSums, files: RunFiles): Output = Snapshots(times, files)
}

/** `snapshots/`: the state at each of [times] and at the end. */
internal class Snapshots(private val times: OutputTimes, private val files: RunFiles) : Output {
    private val directory = files.directory
    private var lastWritten = -1L

    override fun write(simulation: Simulation) {
        if (times.isDue(simulation)) writeState(simulation)
    }

    /** A run that had ended before and is resumed writes its last state again. */
    override fun finish(simulation: Simulation) {
        if (lastWritten != simulation.step) writeState(simulation)
    }

    private fun writeState(simulation: Simulation) {
        val step = simulation.step
        val population = simulation.population
        val copy = { Snapshot.of(population, simulation.boundary, step, simulation.time) }
        files.writer.state(SpheresById.bytes(population), copy) {
            named(titleOf(SnapshotsOutput.name), step) { write(it) }
        }
        lastWritten = step
    }

    /** By the writer. */
    private fun write(state: Snapshot) {
        directory.files.writeAtomically(directory.snapshot(state.step)) { H5md.write(listOf(state), it, Version.text) }
        files.snapshots[state.step] = H5mdChecksum.of(listOf(state))
    }
}
