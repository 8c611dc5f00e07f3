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
import daphnis.core.format.SnapshotFormats
import daphnis.core.population.Population
import daphnis.core.run.RunDirectory
import daphnis.core.run.RunRecord
import daphnis.core.run.Summary
import daphnis.core.run.atHome
import daphnis.core.scenario.FrameSpec
import daphnis.core.scenario.InputException
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
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
public class AnalysisInput internal constructor(
    public val name: String,
    public val scenario: Scenario?,
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

    /** The last state, which is kept: bins, pictures and the box of open space come from it. */
    private val last: Snapshot by lazy { load(size - 1) }

    /**
     * State [k] as its file holds it, not to be changed. Read anew each time, except for the last.
     *
     * @throws FormatException when it cannot be read
     */
    public fun snapshot(k: Int): Snapshot = if (k == size - 1) last else load(k)

    // Of open space the box around the last state, for all states, so that bins and maps of one are those of another.
    private val bounds: BoundaryConditions by lazy { boundary(last.population()) }

    /** State [k], its particles copied. @throws FormatException when its file cannot be read */
    public fun state(k: Int): State = state(k, snapshot(k))

    /** State [k], which [snapshot] is. */
    internal fun state(k: Int, snapshot: Snapshot): State {
        val factor = (scenario?.frame as? FrameSpec.Hill)?.verticalFactor ?: 1.0
        return State(snapshot.population(), bounds, times[k], omega, scenario?.firstBody ?: Int.MAX_VALUE, factor)
    }

    public companion object {
        /**
         * The run in [path], finished or still going on.
         *
         * @param acceptLoss whether files that are not what the run wrote are taken as they are; [notices] say which
         * @throws InputException when there is no run or it has no snapshot
         * @throws FormatException when a file cannot be read, or is not what the run wrote
         */
        public fun ofRun(path: Path, acceptLoss: Boolean = false): AnalysisInput {
            val run = RunDirectory(path)
            run.requireRun()
            val read = ScenarioJson.read(run.scenario)
            val notices = checked(run, read, acceptLoss)
            val scenario = read.atHome(path)
            val steps = run.snapshotSteps()
            if (steps.isEmpty()) {
                throw InputException(
                    path.toString(),
                    null,
                    "has no snapshots; run with --set output.snapshotEvery=10, say",
                )
            }
            fun snapshot(k: Int) = run.readSnapshot(steps[k])
            val first = snapshot(0).population()
            val setup = ScenarioSetup.of(scenario, run.scenario.toString(), first)
            val step = setup.timeStep
            val times = DoubleArray(steps.size) { k ->
                val dt = (step as? daphnis.core.FixedTimeStep)?.duration
                if (dt != null) scenario.startTime + steps[k] * dt else snapshot(k).time
            }
            val transport = if (Files.exists(run.transport)) TransportTable.read(run.transport) else null
            val series = if (Files.exists(run.series)) SeriesTable.read(run.series) else null
            val summary = if (Files.exists(run.summary)) Summary.read(run.summary) else null
            val impacts = if (Files.exists(run.impacts)) ImpactTable.read(run.impacts) else null
            val bounds = { population: Population -> bounded(setup.boundary, population) }
            return AnalysisInput(
                scenario.name, setup.scenario, summary, times, ::snapshot, bounds, setup.angularSpeed,
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
                throw FormatException(
                    "${problems.first()}; bring it back, or take what is there: analyze --accept-loss",
                )
            }
            return problems + record.losses + record.harmlessChanges(scenario)
        }

        /**
         * The states of a foreign file, of any format of [SnapshotFormats].
         *
         * @param scenario what the box, its faces and the frame are; without one they are the file's, and open where it
         *   does not say
         */
        public fun ofFile(path: Path, scenario: Scenario?, source: String): AnalysisInput {
            if (!path.isRegularFile()) throw InputException(path.toString(), null, "no such file or run directory")
            val snapshots = SnapshotFormats.read(path)
            if (snapshots.isEmpty()) throw FormatException("$path: holds no frame")
            for ((k, snapshot) in snapshots.withIndex()) {
                if (snapshot.size == 0) throw FormatException("$path: holds no particle in frame $k")
                val before = if (k == 0) snapshot.time else snapshots[k - 1].time
                if (snapshot.time < before) {
                    val order = "is of time ${snapshot.time}, after $before; times must ascend"
                    throw FormatException("$path: frame $k $order")
                }
            }
            val setup = scenario?.let { ScenarioSetup.of(it, source, snapshots[0].population()) }
            val given = setup?.boundary ?: boundaryOf(snapshots[0])
            if (setup != null) for ((k, it) in snapshots.withIndex()) requireNear(given, it, "$path: frame $k")
            val silent = snapshots.find { !it.hasRadius }
            return AnalysisInput(
                path.name.substringBeforeLast('.'), setup?.scenario, null,
                DoubleArray(snapshots.size) { snapshots[it].time }, { snapshots[it] }, { bounded(given, it) },
                setup?.angularSpeed, null, null, null, null, listOfNotNull(silent?.let { withoutRadii(path, it) }),
            )
        }

        private fun withoutRadii(path: Path, snapshot: Snapshot): String {
            val taken = snapshot.radius.firstOrNull()
            return "$path has no radii: $taken is taken for each; depths, filling factors and occultations are of that"
        }

        /** The box of a scenario is not that which a file's places were checked against. */
        private fun requireNear(boundary: BoundaryConditions, snapshot: Snapshot, where: String) {
            for (axis in 0..2) {
                if (!boundary.repeats(axis)) continue
                val farthest = MOST_BOXES * boundary.box.length(axis)
                for (k in 0 until snapshot.size) {
                    val p = snapshot.position[axis][k]
                    if (Math.abs(p) <= farthest) continue
                    val place = "${"xyz"[axis]} of particle ${snapshot.id[k]} is $p"
                    throw FormatException("$where: $place, more than $MOST_BOXES of the scenario's boxes away")
                }
            }
        }

        private const val MOST_BOXES = 1000

        private fun boundaryOf(snapshot: Snapshot): BoundaryConditions {
            if (snapshot.lengths.any { it.isNaN() }) return daphnis.core.boundary.Open
            if (snapshot.shearOffset != 0.0) {
                throw InputException(
                    "--scenario",
                    null,
                    "is missing; images slide in this file, and the scenario has to say how",
                )
            }
            return Periodic(
                Box.centred(snapshot.lengths[0], snapshot.lengths[1], snapshot.lengths[2]),
                snapshot.periodic[0],
                snapshot.periodic[1],
                snapshot.periodic[2],
            )
        }

        /** Open space ends where the spheres do. */
        private fun bounded(boundary: BoundaryConditions, p: Population): BoundaryConditions {
            if ((0..2).all { boundary.box.length(it).isFinite() } || p.size == 0) return boundary
            fun low(a: DoubleArray) = a.indices.minOf { a[it] - p.radius[it] }
            fun high(a: DoubleArray) = a.indices.maxOf { a[it] + p.radius[it] }
            return Periodic(Box(low(p.x), low(p.y), low(p.z), high(p.x), high(p.y), high(p.z)), false, false, false)
        }
    }
}
