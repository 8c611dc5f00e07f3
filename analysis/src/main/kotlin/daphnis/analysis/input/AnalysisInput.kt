package daphnis.analysis.input

import daphnis.analysis.insitu.State
import daphnis.analysis.series.SeriesTable
import daphnis.analysis.table.UnitNames
import daphnis.analysis.transport.ImpactTable
import daphnis.analysis.transport.TransportTable
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.format.FormatException
import daphnis.core.format.Snapshot
import daphnis.core.format.SnapshotFormat
import daphnis.core.population.Population
import daphnis.core.run.RunDirectory
import daphnis.core.run.RunRecord
import daphnis.core.run.Summary
import daphnis.core.run.atHome
import daphnis.core.scenario.FrameSpec
import daphnis.core.scenario.InputException
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.Surroundings
import daphnis.core.scenario.TimeStepSpec
import daphnis.core.scenario.WayOut
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isRegularFile
import kotlin.io.path.name

/**
 * What there is to analyse: the states of a run or of a foreign file, and what is known about them.
 *
 * @property times time of each state, ascending
 * @property transport of a run that wrote it, else null
 * @property series the time series of a run that wrote it, else null
 * @property impacts the distribution of impact speeds of a run that wrote it, else null
 * @property notices what a user should know of the files, a line each
 * @property scenario of a run, or the one given beside a file; null when there is none
 */
public class AnalysisInput private constructor(
    public val name: String,
    public val scenario: Scenario?,
    private val firstBody: Int,
    public val summary: Summary?,
    public val times: DoubleArray,
    private val load: (Int) -> Snapshot,
    private val boundary: (Population) -> BoundaryConditions,
    public val omega: Double?,
    public val transport: TransportTable?,
    public val series: SeriesTable?,
    public val impacts: ImpactTable?,
    public val directory: RunDirectory?,
    public val notices: List<String>,
) {
    /** Names of the units of all numbers. */
    public val units: UnitNames = UnitNames(scenario?.units)

    /** Number of states. */
    public val size: Int get() = times.size

    /** Reads state [k] as its file holds it. @throws FormatException when it cannot be read */
    public fun frame(k: Int): Snapshot = load(k)

    // Of open space the box around the last state, for all states, so that bins and maps of one are those of another.
    private val bounds: BoundaryConditions by lazy { boundary(load(size - 1).population()) }

    /** Whether the sphere with [id] is one of the scenario's bodies. */
    public fun isBody(id: Int): Boolean = firstBody != Int.MAX_VALUE && id >= firstBody

    /** Reads state [k]. @throws FormatException when its file cannot be read */
    public fun state(k: Int): State {
        val population = load(k).population()
        val factor = (scenario?.frame as? FrameSpec.Hill)?.verticalFactor ?: 1.0
        return State(population, bounds, times[k], omega, firstBody, factor)
    }

    public companion object {
        /**
         * The run in [path], finished or still going on.
         *
         * @param acceptLoss whether files that are not what the run wrote are taken as they are; [notices] say which
         * @throws InputException when there is no run, it has no snapshot, or a file is not what the run wrote
         * @throws FormatException when a file cannot be read
         */
        public fun ofRun(path: Path, acceptLoss: Boolean = false): AnalysisInput {
            val run = RunDirectory(path)
            run.requireRun()
            val read = ScenarioJson.read(run.scenario)
            val notices = checked(run, read, acceptLoss)
            val scenario = read.atHome(path)
            val steps = run.snapshotSteps()
            if (steps.isEmpty()) {
                throw InputException(path.toString(), null, "has no snapshots", WayOut.WRITE_SNAPSHOTS)
            }
            fun frame(k: Int) = run.frame(steps[k])
            val around = Surroundings.of(scenario, run.scenario.toString())
            val step = around.timeStep
            val times = DoubleArray(steps.size) { k ->
                if (step is TimeStepSpec.Fixed) scenario.startTime + steps[k] * step.dt else frame(k).time
            }
            val transport = if (Files.exists(run.transport)) TransportTable.read(run.transport) else null
            val series = if (Files.exists(run.series)) SeriesTable.read(run.series) else null
            val summary = if (Files.exists(run.summary)) Summary.read(run.summary) else null
            val impacts = if (Files.exists(run.impacts)) ImpactTable.read(run.impacts) else null
            val bounds = { population: Population -> bounded(around.boundary, population) }
            val firstBody = scenario.firstBody(frame(0).size)
            return AnalysisInput(
                scenario.name, scenario, firstBody, summary, times, ::frame, bounds, around.angularSpeed,
                transport, series, impacts, run, notices,
            )
        }

        /**
         * Holds what is read beside the states against what the run says it wrote. @return what differs and is accepted
         */
        private fun checked(run: RunDirectory, scenario: Scenario, acceptLoss: Boolean): List<String> {
            val record = RunRecord.of(run)
            val problems =
                record.changes(scenario) + record.problems(run.summary, run.series, run.transport, run.impacts)
            if (problems.isNotEmpty() && !acceptLoss) {
                throw InputException("", null, problems.first(), WayOut.ANALYSE_WITH_LOSS)
            }
            return problems + record.losses + record.harmlessChanges(scenario)
        }

        /**
         * The frames of a foreign file, of any [SnapshotFormat].
         *
         * @param scenario what the box, its faces and the frame are; without one they are the file's, and open where it
         *   does not say
         */
        public fun ofFile(path: Path, scenario: Scenario?, source: String): AnalysisInput {
            if (!path.isRegularFile()) throw InputException(path.toString(), null, "no such file or run directory")
            val frames = SnapshotFormat.of(path).read(path)
            if (frames.isEmpty()) throw FormatException("$path: holds no frame")
            for ((k, frame) in frames.withIndex()) {
                if (frame.size == 0) throw FormatException("$path: holds no particle in frame $k")
                val before = if (k == 0) frame.time else frames[k - 1].time
                if (frame.time < before) {
                    throw FormatException("$path: frame $k is of time ${frame.time}, after $before; times must ascend")
                }
            }
            val around = scenario?.let { Surroundings.of(it, source) }
            val given = around?.boundary ?: ofFrame(frames[0])
            if (around != null) for ((k, frame) in frames.withIndex()) requireNear(given, frame, "$path: frame $k")
            val name = path.name.substringBeforeLast('.')
            val firstBody = scenario?.firstBody(frames[0].size) ?: Int.MAX_VALUE
            return AnalysisInput(
                name, scenario, firstBody, null,
                DoubleArray(frames.size) { frames[it].time }, { frames[it] }, { bounded(given, it) },
                around?.angularSpeed, null, null, null, null, emptyList(),
            )
        }

        /** The box of a scenario is not that which a file's places were checked against. */
        private fun requireNear(boundary: BoundaryConditions, frame: Snapshot, where: String) {
            for (axis in 0..2) {
                if (!boundary.repeats(axis)) continue
                val farthest = MOST_BOXES * boundary.box.length(axis)
                for (k in 0 until frame.size) {
                    val p = frame.position[axis][k]
                    if (Math.abs(p) <= farthest) continue
                    val place = "${"xyz"[axis]} of particle ${frame.id[k]} is $p"
                    throw FormatException("$where: $place, more than $MOST_BOXES of the scenario's boxes away")
                }
            }
        }

        private const val MOST_BOXES = 1000

        private fun ofFrame(frame: Snapshot): BoundaryConditions {
            if (frame.lengths.any { it.isNaN() }) return daphnis.core.boundary.Open
            if (frame.shearOffset != 0.0) {
                val why = "is missing; images slide in this file, and the scenario has to say how"
                throw InputException("scenario", null, why, isArgument = true)
            }
            return Periodic(
                Box.centred(frame.lengths[0], frame.lengths[1], frame.lengths[2]),
                frame.periodic[0],
                frame.periodic[1],
                frame.periodic[2],
            )
        }

        /** Open space ends where the spheres do. */
        private fun bounded(boundary: BoundaryConditions, p: Population): BoundaryConditions {
            if (boundary.box.isFinite || p.size == 0) return boundary
            fun low(a: DoubleArray) = a.indices.minOf { a[it] - p.radius[it] }
            fun high(a: DoubleArray) = a.indices.maxOf { a[it] + p.radius[it] }
            return Periodic(Box(low(p.x), low(p.y), low(p.z), high(p.x), high(p.y), high(p.z)), false, false, false)
        }
    }
}
