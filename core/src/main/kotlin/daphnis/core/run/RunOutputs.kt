package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.format.H5md
import daphnis.core.format.Snapshot
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.PopulationSums
import daphnis.core.scenario.OutputSpec
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name
import kotlin.math.sqrt

/**
 * Everything that a run writes as it goes, except checkpoints: time series, transport, snapshots, log of collisions.
 *
 * @param sums of the population, taken for each row
 * @param statistics sums over all collisions of the run, kept when transport is written
 * @param beginnings of the files that are appended to, by name, to go on from; null to begin anew
 * @param clock nanoseconds; rows that have waited for a second are written
 */
internal class RunOutputs(
    private val directory: RunDirectory,
    private val spec: OutputSpec,
    private val sums: PopulationSums,
    private val transport: TransportRows?,
    private val statistics: CollisionStatistics,
    beginnings: Map<String, Beginning>?,
    clock: () -> Long = System::nanoTime,
) : AutoCloseable {
    private val beginnings = beginnings.orEmpty()
    private val files = directory.files
    private val series = appended(directory.series, SERIES_HEADER, clock)
    private val transportFile = if (transport != null) {
        appended(directory.transport, TransportRows.HEADER, clock)
    } else {
        null
    }
    private val log = if (spec.collisionLog) appended(directory.collisions, LOG_HEADER, clock) else null

    private fun appended(path: Path, header: String, clock: () -> Long) =
        AppendedFile(path, header, beginnings[path.name], files, clock)

    /** The step after which a snapshot was written last; -1 when none was. */
    var lastSnapshot: Long = -1
        private set

    /** Looks at the simulation after a step. */
    fun write(simulation: Simulation) {
        val hasSeries = spec.seriesEvery > 0 && simulation.step % spec.seriesEvery == 0L
        val hasTransport = transport != null && simulation.step % spec.transportEvery == 0L
        val loop = simulation.collisions?.engine?.loop ?: InlineLoop
        if (hasSeries || hasTransport) sums.take(simulation.population, loop)
        if (hasSeries) writeSeries(simulation)
        if (transport != null && transportFile != null) {
            statistics.write(simulation)
            if (hasTransport) transport.append(simulation, sums, statistics, transportFile)
        }
        if (spec.snapshotEvery > 0 && simulation.step % spec.snapshotEvery == 0L) writeSnapshot(simulation)
        if (log != null && simulation.step > 0) writeCollisions(simulation, log)
        series.flushIfDue()
        transportFile?.flushIfDue()
        log?.flushIfDue()
    }

    fun writeSnapshot(simulation: Simulation) {
        val state = Snapshot.of(simulation.population, simulation.boundary, simulation.step, simulation.time)
        files.writeAtomically(directory.snapshot(simulation.step)) { H5md.write(listOf(state), it, Version.text) }
        lastSnapshot = simulation.step
    }

    /** Forces all that is appended to to the disk. @return what the files are now, by name */
    fun force(): Map<String, FileMark> = buildMap {
        put(RunDirectory.SERIES, series.force())
        if (transportFile != null) put(RunDirectory.TRANSPORT, transportFile.force())
        if (log != null) put(RunDirectory.COLLISIONS, log.force())
    }

    /**
     * The distribution of impact speeds so far: small, and written anew each time. @return null when it is not wanted
     */
    fun writeImpacts(): FileMark? {
        if (transport == null) return null
        val lines = StringBuilder("speed_from,speed_to,collisions\n")
        val filled = statistics.speeds.indices.filter { statistics.speeds[it] > 0 }
        if (filled.isNotEmpty()) {
            for (k in filled.first()..filled.last()) {
                lines.append(CollisionStatistics.binEdge(k)).append(',').append(CollisionStatistics.binEdge(k + 1))
                lines.append(',').append(statistics.speeds[k]).append('\n')
            }
        }
        val bytes = lines.toString().toByteArray(Charsets.UTF_8)
        files.writeAtomically(directory.impacts) { Files.write(it, bytes) }
        return FileMark.of(bytes)
    }

    private fun writeSeries(simulation: Simulation) {
        val counters = simulation.collisions?.counters
        val energies = Energies(simulation, sums.kineticEnergy)
        val line = series.line()
        line.append(simulation.step).append(',').append(simulation.time)
        line.append(',').append(sums.count).append(',').append(counters?.collisions ?: 0)
        line.append(',').append(sums.kineticEnergy).append(',').append(sums.granularTemperature)
        line.append(',').append(if (sums.mass > 0) sqrt(2 * sums.kineticEnergy / sums.mass / 3) else 0.0)
        for (axis in 0..2) line.append(',').append(sums.momentum(axis))
        line.append(',').append(energies.potential).append(',').append(energies.total).append(',').append(energies.hill)
        series.endLine()
    }

    private fun writeCollisions(simulation: Simulation, log: AppendedFile) {
        val record = simulation.collisions?.record ?: return
        for (k in 0 until record.size) {
            log.line().append(simulation.step).append(',').append(record.time[k])
            log.line().append(',').append(record.lower[k]).append(',').append(record.higher[k])
            log.line().append(
                ',',
            ).append(
                record.impactSpeed(k),
            ).append(',').append(record.coefficient(k)).append(',').append(record.impulse(k))
            for (axis in 0..2) log.line().append(',').append(record.separation(k, axis))
            log.endLine()
        }
    }

    override fun close() {
        series.use { transportFile.use { log?.close() } }
    }

    private companion object {
        const val SERIES_HEADER =
            "step,time,particles,collisions,kinetic_energy,granular_temperature,rms_component_speed," +
                "momentum_x,momentum_y,momentum_z,potential_energy,total_energy,hill_energy"
        const val LOG_HEADER = "step,time_in_step,id_lower,id_higher,impact_speed,coefficient,impulse,separation_x,separation_y,separation_z"
    }
}
