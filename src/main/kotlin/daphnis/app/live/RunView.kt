package daphnis.app.live

import daphnis.analysis.insitu.State
import daphnis.analysis.plot.PlotScale
import daphnis.analysis.plot.RunPlot
import daphnis.analysis.series.SeriesTable
import daphnis.analysis.table.UnitNames
import daphnis.app.describe.counted
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.format.Snapshot
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import daphnis.core.population.Population
import daphnis.core.run.RecordedRun
import daphnis.core.run.SeriesColumns
import daphnis.core.scenario.Surroundings
import kotlinx.serialization.json.JsonPrimitive
import java.nio.file.Files
import java.nio.file.attribute.FileTime
import java.util.Base64

/**
 * The states of a [run] that is recorded, for a page; the run may still go on.
 *
 * @throws InputException when it has no state
 */
internal class RunView(private val run: RecordedRun) : StateSource {
    private val scenario = run.scenario()
    private val around = scenario?.let { Surroundings.of(it, run.directory.scenario.toString()) }
    private val first = run.steps().firstOrNull()?.let { run.atStep(it) }
        ?: throw InputException("${run.directory.path}", null, "has no state yet", WayOut.WRITE_SNAPSHOTS)
    private val firstBody = scenario?.firstBody(first.size) ?: Int.MAX_VALUE
    private val name = scenario?.name ?: "${run.directory.path.fileName}"
    private val scale = PlotScale(UnitNames(scenario?.units), around?.angularSpeed, meanRadius())
    private val encoder = StateBytes(scale)
    private var steps = emptyList<Long>()
    private var wasComplete: Boolean? = null
    private var seriesTime: FileTime? = null

    private fun meanRadius(): Double =
        (0 until first.size).filter { first.id[it] < firstBody }.map { first.radius[it] }.average()
            .takeIf { it > 0 } ?: 1.0

    override fun bytes(number: Long): ByteArray? {
        if (number !in run.steps()) return null
        val snapshot = try {
            run.atStep(number)
        } catch (e: InputException) {
            // A checkpoint that the next one has replaced meanwhile.
            if (number in run.steps()) throw e
            return null
        }
        val boundary = around?.boundary ?: FileBoundary(snapshot)
        val state = State(snapshot.population(), boundary, snapshot.time, around?.frequencies, firstBody)
        val walls = SeenWalls(boundary, scenario?.boundary, snapshot.time) { piston(it, snapshot) }
        return encoder.of(state, walls, number)
    }

    /** Displacement of the piston at [face], which the time series has; null where it does not reach that far. */
    private fun piston(face: Int, snapshot: Snapshot): Double? {
        val series = run.directory.series
        if (!Files.exists(series)) return null
        val table = SeriesTable.read(series)
        val column = SeriesColumns.PISTON_POSITION[face]
        if (column !in table) return null
        val times = table[SeriesColumns.TIME]
        val places = table[column]
        val next = times.indexOfFirst { it >= snapshot.time }
        if (next < 0) return places.lastOrNull()
        if (next == 0 || times[next] == snapshot.time) return places[next]
        val part = (snapshot.time - times[next - 1]) / (times[next] - times[next - 1])
        return places[next - 1] + part * (places[next] - places[next - 1])
    }

    /** What the page has to know before states. */
    fun introduce(feed: Feed) {
        val directory = JsonPrimitive("${run.directory.path}")
        feed.put(Feed.RUN, "{\"name\": ${JsonPrimitive(name)}, \"directory\": $directory, \"isRecorded\": true}")
    }

    /** Tells [feed] what is new in the directory. To be called by one thread. */
    fun renew(feed: Feed) {
        try {
            val now = run.steps()
            val isComplete = run.summary()?.finished == true
            if (now != steps || isComplete != wasComplete) {
                steps = now
                wasComplete = isComplete
                val end = if (isComplete) "the run is complete" else "the run is not complete"
                val words = JsonPrimitive("${counted(now.size.toLong(), "state")} · $end")
                feed.put(Feed.STATES, "{\"steps\": $now, \"text\": $words}")
            }
            renewSeries(feed)
        } catch (e: Exception) {
            feed.put(Feed.PROBLEM, inWords(e))
        }
    }

    private fun renewSeries(feed: Feed) {
        val series = run.directory.series
        if (!Files.exists(series)) return
        val time = Files.getLastModifiedTime(series)
        if (time == seriesTime) return
        seriesTime = time
        val plot = RunPlot.svg(series, name, scale) ?: return
        feed.put(Feed.SERIES, "data:image/svg+xml;base64," + Base64.getEncoder().encodeToString(plot.toByteArray()))
    }

    /** What is around a state of which only its file is known. */
    private class FileBoundary(private val snapshot: Snapshot) : BoundaryConditions {
        override val box: Box = with(List(3) { edge(it) }) {
            if (snapshot.isInPlane && !snapshot.lengths[2].isFinite()) {
                Box.flat(-get(0), -get(1), get(0), get(1))
            } else {
                Box(-get(0), -get(1), -get(2), get(0), get(1), get(2))
            }
        }

        private fun edge(axis: Int) = snapshot.lengths[axis].let { if (it > 0) it / 2 else Double.POSITIVE_INFINITY }

        override fun contactFaces(axis: Int): ContactFaces = if (box.length(axis).isFinite() &&
            snapshot.lengths[axis].isFinite()
        ) {
            ContactFaces.WALL
        } else {
            ContactFaces.OPEN
        }

        override fun endStep(population: Population, time: Double): Unit = error("a state of a file does not move")
    }
}
