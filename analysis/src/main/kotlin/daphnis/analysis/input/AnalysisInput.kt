package daphnis.analysis.input

import daphnis.analysis.insitu.State
import daphnis.analysis.moonlet.BodyTable
import daphnis.analysis.series.SeriesTable
import daphnis.analysis.table.UnitNames
import daphnis.analysis.transport.ImpactTable
import daphnis.analysis.transport.TransportTable
import daphnis.analysis.wave.ModesTable
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.at
import daphnis.core.format.FormatException
import daphnis.core.format.PackedFile
import daphnis.core.format.Snapshot
import daphnis.core.format.SnapshotFormats
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.run.ProgramRecord
import daphnis.core.run.RunDirectory
import daphnis.core.run.RunRecord
import daphnis.core.run.Summary
import daphnis.core.run.atHome
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.Surroundings
import daphnis.core.scenario.TimeStepSpec
import java.nio.file.Files
import java.nio.file.Path
import java.util.function.IntFunction
import kotlin.io.path.isRegularFile

/**
 * What there is to analyse: the states of a run or of a foreign file, and what is known about them.
 *
 * @property times time of each state, ascending
 * @property frequencies of orbits in Hill's frame, or null when there is none
 * @property transport of a run that wrote it, else null
 * @property series the time series of a run that wrote it, else null
 * @property impacts the distribution of impact speeds of a run that wrote it, else null
 * @property modes the Fourier modes of a run that wrote them, else null
 * @property bodies rows of each body of a run that wrote them, in the order of ids; empty otherwise
 * @property notices what a user should know of the files, a line each
 * @property hasTimes whether [times] are times; false for a file that has none, whose steps they are
 * @property scenario of a run, or the one given beside a file; null when there is none
 */
public class AnalysisInput internal constructor(
    public val name: String,
    public val scenario: Scenario?,
    private val firstBody: Int,
    public val summary: Summary?,
    public val times: DoubleArray,
    private val load: (Int) -> Snapshot,
    private val around: (Int) -> BoundaryConditions,
    public val frequencies: OrbitalFrequencies?,
    public val transport: TransportTable?,
    public val series: SeriesTable?,
    public val impacts: ImpactTable?,
    public val directory: RunDirectory?,
    public val notices: List<String>,
    public val hasTimes: Boolean,
    private val followed: IntArray?,
    private val isEachMoving: Boolean,
    public val modes: ModesTable?,
    public val bodies: List<BodyTable>,
) {
    /** Names of the units of all numbers. */
    public val units: UnitNames = UnitNames(scenario?.units, if (hasTimes) null else "steps")

    /** Angular speed of Hill's frame, or null when there is none. */
    public val omega: Double? get() = frequencies?.omega

    /** Number of states. */
    public val size: Int get() = times.size

    /** The last state, which is kept: bins, pictures and the box of open space come from it. */
    private val last: Snapshot by lazy { load(size - 1) }
    private val lastPopulation by lazy { last.population() }

    /** Whether velocities are known; false for a file that has none, whose particles seem to be at rest. */
    public val hasVelocities: Boolean get() = isEachMoving && last.hasVelocity

    /**
     * State [k] as its file holds it, not to be changed. Read anew each time, except for the last.
     *
     * @throws FormatException when it cannot be read
     */
    public fun snapshot(k: Int): Snapshot = if (k == size - 1) last else load(k)

    /**
     * Ids of particles that are in every state, ascending: those of the last, as particles of a run only ever leave,
     * without those that are not in another state of a file.
     */
    public fun idsThroughout(): IntArray = followed ?: last.id

    /** Whether the sphere with [id] is one of the scenario's bodies. */
    public fun isBody(id: Int): Boolean = firstBody != Int.MAX_VALUE && id >= firstBody

    /** State [k], its particles copied. @throws FormatException when its file cannot be read */
    public fun state(k: Int): State = state(k, snapshot(k))

    /** State [k], which [snapshot], as [snapshot] gives it, is: without a second look into the file. */
    public fun state(k: Int, snapshot: Snapshot): State =
        State(snapshot.population(), boundary(k), times[k], frequencies, firstBody)

    /**
     * What is around state [k], as in [state], without a look into its file. Of open space it is the box around the last
     * state, so that bins and maps of one are those of another.
     */
    public fun boundary(k: Int): BoundaryConditions =
        around(k).at(times[k]).let { if (it.box.isFinite) it else bounded(it, lastPopulation) }

    public companion object {
        /**
         * The run in [path], finished or still going on.
         *
         * @param acceptLoss whether files that are not what the run wrote are taken as they are; [notices] say which
         * @param scenario for the run of a program's own, which knows of none: what its box, frame, units and bodies are
         * @throws InputException when there is no run, it has no snapshot, a file is not what the run wrote, or
         * [scenario] is of another box or not needed
         * @throws FormatException when a file cannot be read
         */
        @JvmStatic
        @JvmOverloads
        public fun ofRun(path: Path, acceptLoss: Boolean = false, scenario: Scenario? = null): AnalysisInput {
            val run = RunDirectory(path)
            run.requireRun()
            if (Files.exists(run.program)) {
                return if (scenario == null) ofProgram(run, acceptLoss) else ofProgram(run, acceptLoss, scenario)
            }
            if (scenario != null) {
                val why = "is for files and for runs of programs; the run in $path has its own"
                throw InputException("scenario", null, why, isArgument = true)
            }
            return ofScenario(run, acceptLoss)
        }

        private fun ofScenario(run: RunDirectory, acceptLoss: Boolean): AnalysisInput {
            val read = ScenarioJson.read(run.scenario)
            val notices = checked(run, read, acceptLoss)
            val scenario = read.atHome(run.path)
            val steps = steps(run)
            val around = Surroundings.of(scenario, run.scenario.toString())
            val dt = around.timeStep.dt
            val clock = scenario.clock(around.timeStep)
            val times = DoubleArray(steps.size) { k ->
                if (dt != null) clock.time(steps[k], dt) else run.readSnapshot(steps[k]).time
            }
            return ofRun(run, scenario.name, scenario, steps, times, around.boundary, around.frequencies, notices)
        }

        /** The run of a program's own: the box and whether it repeats are what its snapshots say. */
        private fun ofProgram(run: RunDirectory, acceptLoss: Boolean): AnalysisInput {
            val record = ProgramRecord.read(run.program)
            val notices = checked(run, null, acceptLoss)
            val steps = steps(run)
            val times = DoubleArray(steps.size) {
                val snapshot = run.readSnapshot(steps[it])
                if (snapshot.shearOffset != 0.0) {
                    val why = "holds a run of $record, in which images slide; it takes a scenario to say how"
                    throw InputException("${run.path}", null, "$why: analyze it with one")
                }
                snapshot.time
            }
            val boundary = FileBoxes(run.path, listOf(run.readSnapshot(steps[0])), hasTimes = true).boundaries[0]
            val notice = "${run.path}: is of $record: without a scenario units, rotating frame and bodies are not known"
            return ofRun(
                run,
                record.program,
                null,
                steps,
                times,
                boundary,
                null,
                notices + notice,
            )
        }

        /** The run of a program's own, in the space and time of [scenario]. */
        private fun ofProgram(run: RunDirectory, acceptLoss: Boolean, scenario: Scenario): AnalysisInput {
            val record = ProgramRecord.read(run.program)
            val notices = checked(run, null, acceptLoss)
            val around = Surroundings.of(scenario, "scenario")
            val steps = steps(run)
            val times = DoubleArray(steps.size) {
                val snapshot = run.readSnapshot(steps[it])
                requireBox(around.boundary.at(snapshot.time), snapshot, run)
                snapshot.time
            }
            // Which laws and forces were at work, only the program knows.
            val known = scenario.copy(description = "")
            return ofRun(run, record.program, known, steps, times, around.boundary, around.frequencies, notices)
        }

        private fun steps(run: RunDirectory): List<Long> = run.snapshotSteps().ifEmpty {
            throw InputException("${run.path}", null, "has no snapshots", WayOut.WRITE_SNAPSHOTS)
        }

        private fun ofRun(
            run: RunDirectory,
            name: String,
            scenario: Scenario?,
            steps: List<Long>,
            times: DoubleArray,
            boundary: BoundaryConditions,
            frequencies: OrbitalFrequencies?,
            notices: List<String>,
        ): AnalysisInput {
            val transport = if (Files.exists(run.transport)) TransportTable.read(run.transport) else null
            val series = if (Files.exists(run.series)) SeriesTable.read(run.series) else null
            val summary = if (Files.exists(run.summary)) Summary.read(run.summary) else null
            val hasImpacts = Files.exists(run.impacts) && !RunRecord.of(run).isNewer(run.impacts)
            val impacts = if (hasImpacts) ImpactTable.read(run.impacts) else null
            val modes = if (Files.exists(run.modes)) ModesTable.read(run.modes) else null
            val firstBody = scenario?.firstBody(run.readSnapshot(steps[0]).size) ?: Int.MAX_VALUE
            val bodies = if (Files.exists(run.bodies)) BodyTable.read(run.bodies) else emptyList()
            return AnalysisInput(
                name, scenario, firstBody, summary, times, { run.readSnapshot(steps[it]) }, { boundary }, frequencies,
                transport, series, impacts, run, notices, true, null, true, modes, bodies,
            )
        }

        /**
         * Holds what is read beside the states against what the run says it wrote.
         *
         * @return what differs and is accepted
         */
        private fun checked(run: RunDirectory, scenario: Scenario?, acceptLoss: Boolean): List<String> {
            val record = RunRecord.of(run)
            val changes = scenario?.let { record.changes(it) }.orEmpty()
            val tables = arrayOf(run.summary, run.series, run.transport, run.impacts, run.modes, run.bodies)
            val problems = changes + record.problems(*tables)
            val newer = listOf(run.impacts).filter { Files.exists(it) && record.isNewer(it) }
                .map { "$it: is not what the run's last checkpoint knows, and is left out; resume writes it anew" }
            if (problems.isNotEmpty() && !acceptLoss) {
                throw InputException("", null, problems.first(), WayOut.ANALYSE_WITH_LOSS)
            }
            return problems + newer + record.losses + scenario?.let { record.harmlessChanges(it) }.orEmpty()
        }

        /**
         * The states of a foreign file, of any format of [SnapshotFormats].
         *
         * @param scenario what the box, its faces and the frame are; without one they are the file's, of each state its
         *   own, and open where it does not say
         * @param timeStep time of a step, for a file that has no times
         * @throws InputException when [scenario] is of another box, or [timeStep] is not needed or not > 0
         */
        @JvmStatic
        @JvmOverloads
        public fun ofFile(path: Path, scenario: Scenario?, source: String, timeStep: Double? = null): AnalysisInput {
            if (!path.isRegularFile()) throw InputException(path.toString(), null, "no such file or run directory")
            val around = scenario?.let { Surroundings.of(it, source) }
            val file = FileStates(path, around, source, timeStep)
            val states = file.states
            val boxes = if (around == null) FileBoxes(path, states, file.hasTimes) else null
            val firstBody = scenario?.firstBody(states[0].size) ?: Int.MAX_VALUE
            return AnalysisInput(
                PackedFile.plainName(path).substringBeforeLast('.'), scenario, firstBody, null,
                DoubleArray(states.size) { states[it].time }, { states[it] },
                { k -> boxes?.boundaries?.get(k) ?: around!!.boundary },
                around?.frequencies, null, null, null, null,
                file.notices + boxes?.notices.orEmpty(), file.hasTimes, file.common, file.hasVelocities,
                null, emptyList(),
            )
        }

        /**
         * States that a program has by other means, in one box, without a scenario.
         *
         * @param times of each state, ascending
         * @param frequencies of orbits in Hill's frame, or null
         * @param read state k, 0 until the number of [times]; may be called from one thread at a time, and anew for the
         *   same k
         */
        @JvmStatic
        public fun ofStates(
            name: String,
            times: DoubleArray,
            boundary: BoundaryConditions,
            frequencies: OrbitalFrequencies?,
            read: IntFunction<Snapshot>,
        ): AnalysisInput {
            require(times.isNotEmpty()) { "there is no state" }
            return AnalysisInput(
                name, null, Int.MAX_VALUE, null, times, read::apply, { boundary }, frequencies, null, null, null,
                null, emptyList(), true, null, true, null, emptyList(),
            )
        }
    }
}
