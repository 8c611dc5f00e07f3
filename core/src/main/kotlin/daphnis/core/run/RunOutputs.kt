package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.format.Frame
import daphnis.core.format.H5md
import daphnis.core.output.CollisionStatistics
import daphnis.core.population.Conserved
import daphnis.core.population.granularTemperature
import daphnis.core.scenario.OutputSpec
import kotlin.math.sqrt

/**
 * Everything that a run writes as it goes, except checkpoints: time series, transport, snapshots, log of collisions.
 *
 * @param statistics sums over all collisions of the run, kept when transport is written
 */
internal class RunOutputs(
    private val directory: RunDirectory,
    private val spec: OutputSpec,
    private val transport: TransportRows?,
    private val statistics: CollisionStatistics,
    lengths: Map<String, Long>?,
) : AutoCloseable {
    private val series = AppendedFile(directory.series, SERIES_HEADER, lengths?.get(RunDirectory.SERIES))
    private val transportFile =
        if (transport != null) AppendedFile(directory.transport, TransportRows.HEADER, lengths?.get(RunDirectory.TRANSPORT)) else null
    private val log = if (spec.collisionLog) AppendedFile(directory.collisions, LOG_HEADER, lengths?.get(RunDirectory.COLLISIONS)) else null

    /** Looks at the simulation after a step. */
    fun write(simulation: Simulation) {
        if (spec.seriesEvery > 0 && simulation.step % spec.seriesEvery == 0L) writeSeries(simulation)
        if (transport != null && transportFile != null) {
            statistics.write(simulation)
            if (simulation.step % spec.transportEvery == 0L) transport.append(simulation, statistics, transportFile)
        }
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
        if (transportFile != null) {
            put(RunDirectory.TRANSPORT, transportFile.force())
            writeImpacts()
        }
        if (log != null) put(RunDirectory.COLLISIONS, log.force())
    }

    /** The distribution of impact speeds so far: small, and written anew each time. */
    private fun writeImpacts() {
        val lines = StringBuilder("speed_from,speed_to,collisions\n")
        val filled = statistics.speeds.indices.filter { statistics.speeds[it] > 0 }
        if (filled.isNotEmpty()) {
            for (k in filled.first()..filled.last()) {
                lines.append(CollisionStatistics.binEdge(k)).append(',').append(CollisionStatistics.binEdge(k + 1))
                lines.append(',').append(statistics.speeds[k]).append('\n')
            }
        }
        writeAtomically(directory.impacts) { java.nio.file.Files.writeString(it, lines) }
    }

    private fun writeSeries(simulation: Simulation) {
        val sums = Conserved.of(simulation.population)
        val counters = simulation.collisions?.counters
        val line = series.line()
        line.append(simulation.step).append(',').append(simulation.time)
        line.append(',').append(sums.count).append(',').append(counters?.collisions ?: 0)
        line.append(',').append(sums.kineticEnergy)
        line.append(',').append(granularTemperature(simulation.population, simulation.boundary.meanFlow))
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
        series.use { transportFile.use { log?.close() } }
    }

    private companion object {
        const val SERIES_HEADER =
            "step,time,particles,collisions,kinetic_energy,granular_temperature,rms_component_speed,momentum_x,momentum_y,momentum_z"
        const val LOG_HEADER = "step,time_in_step,id_lower,id_higher,impact_speed,coefficient,impulse,separation_x,separation_y,separation_z"
    }
}
