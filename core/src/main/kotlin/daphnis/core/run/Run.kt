package daphnis.core.run

import daphnis.core.Engines
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.cluster.FleetException
import daphnis.core.cluster.NodeException
import daphnis.core.engine.EngineFactory
import daphnis.core.input.InputException
import daphnis.core.scenario.ResolvedScenario
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.warnings
import java.io.IOException
import java.nio.file.Path
import java.util.function.BooleanSupplier

/**
 * A scenario or a [Program] being run in a run directory. Made by [start] or [resume], and run once by [execute]. One
 * thread.
 *
 * @property resumedFrom the step from which it continues; 0 at a start
 * @property notices what a user should know, one line each, such as [warnings] or a damaged checkpoint that was skipped
 */
public class Run internal constructor(
    public val directory: RunDirectory,
    private val plan: RunPlan,
    private val origin: String,
    private val checkpoints: Checkpoints,
    private val from: GoodCheckpoint?,
    private val lock: AutoCloseable,
    public val notices: List<String>,
) : AutoCloseable {
    public val simulation: Simulation = plan.simulation
    public val resumedFrom: Long = simulation.step
    private var isExecuted = false
    private var isClosed = false

    /** What [execute] asks before every step, unless it is given another. */
    internal var cancelled: BooleanSupplier = BooleanSupplier { false }

    /** The scenario that is run; null for a [Program]. */
    public val scenario: ResolvedScenario? get() = plan.scenario

    /** Whether the run writes a time series. */
    public val hasSeries: Boolean get() = !SeriesOutput.times(plan.output).isNever

    /** Time at which the run ends. */
    public val until: Double get() = plan.until

    /**
     * Advances to the end.
     *
     * @param watcher an output that is called after all others; nothing of it is kept
     * @param cancelled called before every step; when it returns true, the run ends with a checkpoint and a summary
     *   marked unfinished. Unless given, what the builder of the run was given
     *
     * @throws RunException when the simulation or an output fails, or a file cannot be written; the last checkpoint
     *   stays
     *
     * @throws IllegalStateException when it has been called before, or the run is closed; [resume] continues it
     */
    @JvmOverloads
    public fun execute(watcher: Output = Output { }, cancelled: BooleanSupplier = this.cancelled): Summary {
        check(!isClosed) { "this run is closed" }
        check(!isExecuted) { "this run was executed before; resume continues it" }
        isExecuted = true
        try {
            val beginnings = from?.beginnings.orEmpty()
            val states = from?.checkpoint?.meta?.snapshots.orEmpty()
            val writer = directory.files.writer()
            RunFiles(directory, beginnings, writer, units = scenario?.units, snapshots = states).use { files ->
                val usual = named(PeriodicOutputs.make(plan.output, plan.sums, files), simulation)
                from?.let { restore(usual, it.checkpoint.outputs) }
                val last = NamedOutput("the watcher", watcher, simulation)
                RunOutputs(usual + plan.own, last).use {
                    return Execution(directory, plan, origin, checkpoints, from, files, it).carryOut(cancelled)
                }
            }
        } catch (e: IllegalStateException) {
            throw failed(e, simulation.step)
        } catch (e: IllegalArgumentException) {
            throw failed(e, simulation.step)
        } catch (e: FleetException) {
            throw failed(e, simulation.step)
        } catch (e: NodeException) {
            throw failed(e, simulation.step)
        } catch (e: IOException) {
            throw RunException("${cannotWrite(directory, e).message}; ${wayOn()}", e)
        }
    }

    private fun wayOn() = if (directory.holdsRun()) {
        "earlier output is intact; fix this, then resume"
    } else {
        "the run was removed while it was in progress"
    }

    override fun close() {
        isClosed = true
        plan.use { lock.close() }
    }

    public companion object {
        /** Names the parts of a run of [scenario] one by one. */
        @JvmStatic
        public fun builder(scenario: Scenario): ScenarioRunBuilder = ScenarioRunBuilder(scenario)

        /** Names the parts of a run of [program] one by one. */
        @JvmStatic
        public fun builder(program: Program): ProgramRunBuilder = ProgramRunBuilder(program)

        /** Names one by one what is needed to continue the run of a scenario in [path]. */
        @JvmStatic
        public fun resuming(path: Path): ResumeBuilder = ResumeBuilder(path)

        /**
         * Makes the run directory [path] and the initial state.
         *
         * @param source what to call the scenario in messages
         * @param force whether a run that is in the directory may be replaced
         * @param outputs further outputs by name, in the order in which they are called; what they save is found again
         *   by name
         *
         * @param from a state of another run, in place of the scenario's own initial state; its particles and its time
         *   go on, and `particles`, `velocities` and `placement` of the scenario are not used
         *
         * @throws InputException for wrong input; what was in the directory is as it was
         * @throws RunException when the directory cannot be written
         */
        @JvmStatic
        @JvmOverloads
        public fun start(
            scenario: Scenario,
            source: String,
            path: Path,
            force: Boolean = false,
            engines: EngineFactory = Engines,
            outputs: Map<String, Output> = emptyMap(),
            from: RunOrigin? = null,
        ): Run = startRun(scenario, source, RunDirectory(path), force, engines, outputs, from)

        /**
         * The run in [path], finished or still going on, to read its states.
         *
         * @throws InputException when there is no run
         */
        @JvmStatic
        public fun open(path: Path): RecordedRun = RecordedRun(RunDirectory(path))

        /**
         * Continues the run in [path] from its last good checkpoint, or from the start when it was killed before the
         * first one.
         *
         * @param until a new end, or null for the scenario's
         * @param acceptLoss whether to continue with damaged tables as they are; [notices] tell what is lost
         * @param outputs as at [start]; what other outputs had saved is dropped, and [notices] tell that
         * @throws InputException when there is no run, no checkpoint can be used, a table is damaged, or the scenario
         *   was changed in a way that makes another run
         *
         * @throws RunException when the directory cannot be written, or an output cannot continue from what it saved
         */
        @JvmStatic
        @JvmOverloads
        public fun resume(
            path: Path,
            until: Double? = null,
            engines: EngineFactory = Engines,
            acceptLoss: Boolean = false,
            outputs: Map<String, Output> = emptyMap(),
        ): Run = resumeRun(RunDirectory(path), until, engines, acceptLoss, outputs)

        /**
         * Makes the run directory [path] for [program], which starts from its own population.
         *
         * @param force whether a run that is in the directory may be replaced
         * @throws IllegalArgumentException when the program's simulation is not as [Program.simulation] requires
         * @throws InputException when the directory is in use or holds something else, which is as it was then
         * @throws RunException when the directory cannot be written
         */
        @JvmStatic
        @JvmOverloads
        public fun start(program: Program, path: Path, force: Boolean = false): Run =
            startRun(program, RunDirectory(path), force)

        /**
         * Continues the run of [program] in [path] from its last good checkpoint, or from the start when it was killed
         * before the first one. It ends in the same bits as an uninterrupted run.
         *
         * @param acceptLoss as for a scenario
         * @throws IllegalArgumentException when the program's simulation is not as [Program.simulation] requires
         * @throws InputException when there is no run of this program and version, no checkpoint can be used, or a
         *   table is damaged
         *
         * @throws RunException when the directory cannot be written, or an output cannot continue from what it saved
         */
        @JvmStatic
        @JvmOverloads
        public fun resume(program: Program, path: Path, acceptLoss: Boolean = false): Run =
            resumeRun(program, RunDirectory(path), acceptLoss)
    }
}
