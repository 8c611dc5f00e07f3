package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.format.Frame
import daphnis.core.format.H5md
import daphnis.core.population.Conserved
import daphnis.core.population.granularTemperature
import daphnis.core.scenario.OutputSpec
import kotlin.math.sqrt

/** Everything that a run writes as it goes, except checkpoints: time series, snapshots, log of collisions. */
internal class RunOutputs(private val directory: RunDirectory, private val spec: OutputSpec, lengths: Map<String, Long>?) : AutoCloseable {
    private val series = AppendedFile(directory.series, SERIES_HEADER, lengths?.get(RunDirectory.SERIES))
    private val log = if (spec.collisionLog) AppendedFile(directory.collisions, LOG_HEADER, lengths?.get(RunDirectory.COLLISIONS)) else null

    /** Looks at the simulation after a step. */
    fun write(simulation: Simulation) {
        if (spec.seriesEvery > 0 && simulation.step % spec.seriesEvery == 0L) writeSeries(simulation)
        if (spec.snapshotEvery > 0 && simulation.step % spec.snapshotEvery == 0L) writeSnapshot(simulation)
        if (log != null && simulation.step > 0) writeCollisions(simulation, log)
    }

    fun writeSnapshot(simulation: Simulation) {
        val frame = Frame.of(simulation.population, simulation.boundary, simulation.step, simulation.time)
        writeAtomically(directory.snapshot(simulation.step)) { H5md.write(listOf(frame), it, Version.text) }
    }

    /** Forces all to the disk. @return length of each appended file by name */
    fun force(): Map<String, Long> = buildMap {
        put(RunDirectory.SERIES, series.force())
        if (log != null) put(RunDirectory.COLLISIONS, log.force())
    }

    private fun writeSeries(simulation: Simulation) {
        val sums = Conserved.of(simulation.population)
        val counters = simulation.collisions?.counters
        val line = series.line()
        line.append(simulation.step).append(',').append(simulation.time)
        line.append(',').append(sums.count).append(',').append(counters?.collisions ?: 0)
        line.append(',').append(sums.kineticEnergy)
        line.append(',').append(granularTemperature(simulation.population, simulation.boundary.isSheared))
        line.append(',').append(if (sums.mass > 0) sqrt(2 * sums.kineticEnergy / sums.mass / 3) else 0.0)
        line.append(',').append(sums.momentumX).append(',').append(sums.momentumY).append(',').append(sums.momentumZ)
        series.endLine()
    }

    private fun writeCollisions(simulation: Simulation, log: AppendedFile) {
        val record = simulation.collisions?.record ?: return
        for (k in 0 until record.size) {
            log.line().append(simulation.step).append(',').append(record.time[k])
            log.line().append(',').append(record.lower[k]).append(',').append(record.higher[k])
            log.line().append(',').append(record.impactSpeed(k)).append(',').append(record.coefficient(k)).append(',').append(record.impulse(k))
            for (axis in 0..2) log.line().append(',').append(record.separation(k, axis))
            log.endLine()
        }
    }

    override fun close() {
        series.use { log?.close() }
    }

    private companion object {
        const val SERIES_HEADER =
            "step,time,particles,collisions,kinetic_energy,granular_temperature,rms_component_speed,momentum_x,momentum_y,momentum_z"
        const val LOG_HEADER = "step,time_in_step,id_lower,id_higher,impact_speed,coefficient,impulse,separation_x,separation_y,separation_z"
    }
}
