package daphnis.core.run

import daphnis.core.Engines
import daphnis.core.Simulation
import daphnis.core.collision.CollisionCounters
import daphnis.core.engine.EngineFactory
import daphnis.core.scenario.InputException
import daphnis.core.scenario.ResolvedScenario
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.warnings
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * A scenario being carried out in a run directory: made by [start] or [resume], done by [execute]. One thread.
 *
 * @property resumedFrom the step it goes on from; 0 at a start
 * @property notices what a user should know, a line each, such as [warnings] or a damaged checkpoint that was passed
 *   over
 */
public class Run internal constructor(
    public val directory: RunDirectory,
    public val scenario: ResolvedScenario,
    private val scenarioText: String,
    private val parts: RunParts,
    private val checkpoints: Checkpoints,
    private val from: GoodCheckpoint?,
    private val lock: AutoCloseable,
    public val notices: List<String>,
) : AutoCloseable {
    public val simulation: Simulation = parts.simulation
    public val resumedFrom: Long = simulation.step
    private val secondsBefore = from?.checkpoint?.meta?.wallSeconds ?: 0.0

    /** Whether it writes a time series. */
    public val hasSeries: Boolean get() = scenario.output.seriesEvery > 0

    /** Time at which it ends. */
    public val until: Double get() = scenario.end

    /**
     * Advances to the end.
     *
     * @param cancelled asked before every step; when true the run ends with a checkpoint and a summary that says
     *   unfinished
     * @throws RunException when the simulation fails or a file cannot be written; the last checkpoint stands
     */
    public fun execute(
        observer: RunObserver = RunObserver { _, _, _ -> },
        cancelled: () -> Boolean = { false },
    ): Summary {
        val begin = System.nanoTime()
        fun seconds() = (System.nanoTime() - begin) * 1e-9
        try {
            RunOutputs(
                directory,
                scenario.output,
                parts.sums,
                parts.transport,
                parts.statistics,
                from?.beginnings,
            ).use { outputs ->
                if (from == null) {
                    outputs.write(simulation)
                    checkpoint(outputs, 0.0)
                }
                var finished = isDone()
                while (!finished && !cancelled()) {
                    advance(outputs) { secondsBefore + seconds() }
                    outputs.write(simulation)
                    observer.afterStep(simulation, until, seconds())
                    finished = isDone()
                    val every = scenario.output.checkpointEvery
                    if (!finished && every > 0 && simulation.step % every == 0L) {
                        checkpoint(outputs, secondsBefore + seconds())
                    }
                }
                if (finished && outputs.lastSnapshot != simulation.step) outputs.writeSnapshot(simulation)
                val summary = Summary.of(scenario, parts, finished, secondsBefore + seconds())
                checkpoint(outputs, summary.wallSeconds, summary)
                summary.write(directory)
                return summary
            }
        } catch (e: IllegalStateException) {
            throw RunException(e.message.orEmpty())
        } catch (e: IllegalArgumentException) {
            throw RunException("step ${simulation.step + 1}: ${e.message}")
        } catch (e: IOException) {
            throw RunException("${cannotWrite(directory, e).message}; ${wayOn()}")
        }
    }

    private fun wayOn() = if (Files.exists(directory.scenario)) {
        "what was written before stands, go on with resume when that is mended"
    } else {
        "the run was removed while it went on"
    }

    /** One step. When it fails, the state before it is kept as a checkpoint. */
    private fun advance(outputs: RunOutputs, wallSeconds: () -> Double) {
        try {
            simulation.advance()
        } catch (e: RuntimeException) {
            checkpoint(outputs, wallSeconds())
            throw RunException("step ${simulation.step + 1}: ${e.message ?: e.javaClass.name}")
        } catch (e: Error) {
            // There may be no memory for it, and then the error is what matters.
            try {
                checkpoint(outputs, wallSeconds())
            } catch (another: Throwable) {
                if (another !== e) e.addSuppressed(another)
            }
            throw e
        }
    }

    private fun isDone(): Boolean = simulation.time >= until - endSlack(scenario.timeStep)

    /** @param summary of a run that ends here, which the checkpoint knows before it is written */
    private fun checkpoint(outputs: RunOutputs, wallSeconds: Double, summary: Summary? = null) {
        val appended = outputs.force()
        val whole = listOfNotNull(
            outputs.writeImpacts()?.let { RunDirectory.IMPACTS to it },
            summary?.let { RunDirectory.SUMMARY to FileMark.of(it.bytes()) },
        ).toMap()
        val c = simulation.collisions?.counters ?: CollisionCounters()
        val statistics = parts.statistics.takeIf { parts.transport != null }
        val meta = CheckpointMeta(
            simulation.step, simulation.time,
            c.collisions, c.wallCollisions, c.guardActivations, c.redoneSteps, c.causalityReplays,
            wallSeconds, appended, whole, statistics?.sums().orEmpty(), statistics?.speeds?.asList().orEmpty(),
            from?.losses.orEmpty(),
        )
        checkpoints.write(meta, scenarioText, simulation.population)
    }

    override fun close() {
        simulation.use { lock.close() }
    }

    public companion object {
        /**
         * Makes the run directory [path] and the initial state.
         *
         * @param source what to call the scenario in messages
         * @param force whether a run that is in the directory may be replaced
         * @throws InputException for wrong input; what was in the directory is as it was
         * @throws RunException when the directory cannot be written
         */
        public fun start(
            scenario: Scenario,
            source: String,
            path: Path,
            force: Boolean = false,
            engines: EngineFactory = Engines,
        ): Run = startRun(scenario, source, RunDirectory(path), force, engines)

        /**
         * Goes on with the run in [path] from its last good checkpoint, or from the start when it was killed before the
         * first.
         *
         * @param until a new end, or null for the scenario's
         * @param acceptLoss whether tables that are damaged are gone on with as they are; [notices] say what is lost
         * @throws InputException when there is no run, no checkpoint can be used, a table is damaged, or the scenario
         *   was changed in what makes the run
         * @throws RunException when the directory cannot be written
         */
        public fun resume(
            path: Path,
            until: Double? = null,
            engines: EngineFactory = Engines,
            acceptLoss: Boolean = false,
        ): Run = resumeRun(RunDirectory(path), until, engines, acceptLoss)
    }
}
