package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.collision.CollisionCounters
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.EngineFactory
import daphnis.core.engine.named.Engines
import daphnis.core.force.SelfGravity
import daphnis.core.output.CollisionStatistics
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.PopulationSums
import daphnis.core.population.stateDigest
import daphnis.core.scenario.InputException
import daphnis.core.scenario.PlacementSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.scenario.TimeStepSpec
import daphnis.core.scenario.warnings
import daphnis.core.search.Overlap
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption

/**
 * A scenario being carried out in a run directory: made by [start] or [resume], done by [execute]. One thread.
 *
 * @property resumedFrom the step it goes on from; 0 at a start
 * @property notices what a user should know, a line each, such as [warnings] or a damaged checkpoint that was passed over
 */
public class Run private constructor(
    public val directory: RunDirectory,
    private val scenario: Scenario,
    public val simulation: Simulation,
    private val sums: PopulationSums,
    private val transport: TransportRows?,
    private val statistics: CollisionStatistics,
    private val lengths: Map<String, Long>?,
    private val secondsBefore: Double,
    private val lock: AutoCloseable,
    public val notices: List<String>,
) : AutoCloseable {
    public val resumedFrom: Long = simulation.step

    /** Whether it writes a time series. */
    public val hasSeries: Boolean get() = scenario.output.seriesEvery > 0

    /** Time at which it ends. */
    public val until: Double get() = scenario.end

    /**
     * Advances to the end.
     *
     * @param cancelled asked before every step; when true the run ends with a checkpoint and a summary that says unfinished
     * @throws RunException when the simulation fails or a file cannot be written; the last checkpoint stands
     */
    public fun execute(observer: RunObserver = RunObserver { _, _, _ -> }, cancelled: () -> Boolean = { false }): Summary {
        val begin = System.nanoTime()
        fun seconds() = (System.nanoTime() - begin) * 1e-9
        try {
            RunOutputs(directory, scenario.output, sums, transport, statistics, lengths).use { outputs ->
                if (lengths == null) {
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
                    if (!finished && every > 0 && simulation.step % every == 0L) checkpoint(outputs, secondsBefore + seconds())
                }
                if (finished && !Files.exists(directory.snapshot(simulation.step))) outputs.writeSnapshot(simulation)
                checkpoint(outputs, secondsBefore + seconds())
                return summary(finished, secondsBefore + seconds()).also { it.write(directory.summary) }
            }
        } catch (e: IllegalStateException) {
            throw RunException(e.message.orEmpty())
        } catch (e: IllegalArgumentException) {
            throw RunException("step ${simulation.step + 1}: ${e.message}")
        } catch (e: IOException) {
            throw RunException("cannot write to ${directory.path}: ${RunDirectory.reason(e)}; what was written before stands, go on with resume when there is room")
        }
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
                e.addSuppressed(another)
            }
            throw e
        }
    }

    /** A whole number of fixed steps can fall short of the end by round-off; that is not another step. */
    private fun isDone(): Boolean {
        val step = scenario.timeStep
        val slack = if (step is TimeStepSpec.Fixed) step.dt * END_SLACK else 0.0
        return simulation.time >= until - slack
    }

    private fun checkpoint(outputs: RunOutputs, wallSeconds: Double) {
        val lengths = outputs.force()
        val c = simulation.collisions?.counters ?: CollisionCounters()
        val meta = CheckpointMeta(
            simulation.step, simulation.time, c.collisions, c.wallCollisions, c.guardActivations, c.redoneSteps, c.causalityReplays, wallSeconds, lengths,
            if (transport != null) statistics.sums() else emptyList(), if (transport != null) statistics.speeds.asList() else emptyList(),
        )
        // The one before stays until the new one is whole on the disk. Killed between the two moves, there is the previous one only.
        val fresh = directory.path.resolve("checkpoint.new")
        writeAtomically(fresh) { Checkpoint.write(meta, simulation.population, it) }
        if (Files.exists(
                directory.checkpoint,
            )
        ) {
            Files.move(directory.checkpoint, directory.previousCheckpoint, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING)
        }
        Files.move(fresh, directory.checkpoint, StandardCopyOption.ATOMIC_MOVE)
        forceDirectory(directory.path)
    }

    private fun summary(finished: Boolean, seconds: Double): Summary {
        val population = simulation.population
        sums.take(population, simulation.collisions?.engine?.loop ?: InlineLoop)
        val c = simulation.collisions?.counters ?: CollisionCounters()
        val engine = simulation.collisions?.engine
        return Summary(
            stateDigest = stateDigest(population),
            finished = finished,
            scenario = scenario.name,
            particles = population.size,
            steps = simulation.step,
            time = simulation.time,
            collisions = c.collisions,
            wallCollisions = c.wallCollisions,
            engine = engine?.name ?: "none",
            threads = engine?.threads ?: 1,
            wallSeconds = seconds,
            stepsPerSecond = if (seconds > 0) simulation.step / seconds else 0.0,
            maxOverlap = Overlap.deepest(population, simulation.boundary, simulation.time, engine?.threads ?: 1).depth,
            guardActivations = c.guardActivations,
            redoneSteps = c.redoneSteps,
            causalityReplays = c.causalityReplays,
            energy = sums.kineticEnergy,
            temperature = sums.granularTemperature,
            momentum = List(3) { sums.momentum(it) },
            version = Version.text,
            jvm = "${System.getProperty("java.vm.name")} ${System.getProperty("java.runtime.version")}",
        )
    }

    override fun close() {
        simulation.use { lock.close() }
    }

    public companion object {
        private const val END_SLACK = 1e-6

        /**
         * Makes the run directory [path] and the initial state.
         *
         * @param source what to call the scenario in messages
         * @throws InputException for wrong input
         */
        public fun start(scenario: Scenario, source: String, path: Path, force: Boolean = false, engines: EngineFactory = Engines): Run {
            val setup = ScenarioSetup.of(scenario, source)
            val simulation = simulation(setup, null, source, engines)
            val directory = RunDirectory(path)
            directory.create(force)
            val lock = directory.lock()
            try {
                val resolved = keepParticleFile(setup.scenario, directory)
                writeAtomically(directory.scenario) { Files.writeString(it, ScenarioJson.write(resolved)) }
                val statistics = CollisionStatistics()
                val notices = setup.notices + warnings(setup)
                return Run(directory, resolved, simulation, sums(setup), transport(setup), statistics, null, 0.0, lock, notices)
            } catch (e: IOException) {
                lock.close()
                throw RunException("cannot write to $path: ${RunDirectory.reason(e)}")
            }
        }

        /** The run directory keeps the particles it started from, so that its scenario means the same wherever it goes. */
        private fun keepParticleFile(scenario: Scenario, directory: RunDirectory): Scenario {
            val placement = scenario.placement as? PlacementSpec.File ?: return scenario
            val original = Path.of(placement.path)
            val copy = directory.initial(original)
            Files.copy(original, copy, StandardCopyOption.REPLACE_EXISTING)
            return scenario.copy(placement = placement.copy(path = copy.fileName.toString()))
        }

        /**
         * Goes on with the run in [path] from its last good checkpoint, or from the start when it was killed before the first.
         *
         * @param until a new end, or null for the scenario's
         * @throws InputException when there is no run, or no checkpoint can be used
         */
        public fun resume(path: Path, until: Double? = null, engines: EngineFactory = Engines): Run {
            val directory = RunDirectory(path)
            directory.requireRun()
            val lock = directory.lock()
            try {
                val read = ScenarioJson.read(directory.scenario).atHome(path)
                if (until != null && !(until > read.startTime && until.isFinite())) throw InputException("--until", null, "is $until; it must be > ${read.startTime}")
                val scenario = read.copy(until = until ?: read.until)
                val notices = ArrayList<String>()
                val checkpoint = lastGood(directory, notices)
                if (until != null) checkLater(until, checkpoint?.meta?.time ?: 0.0, scenario)
                val setup = ScenarioSetup.of(scenario, directory.scenario.toString(), checkpoint?.population)
                val simulation = simulation(setup, checkpoint?.meta, directory.scenario.toString(), engines)
                // Snapshots after the checkpoint are written again, to the same bits; the summary is of a run that goes on.
                Files.deleteIfExists(directory.summary)
                Files.createDirectories(directory.snapshots)
                val meta = checkpoint?.meta
                val statistics = CollisionStatistics()
                if (meta != null && meta.collisionSums.isNotEmpty()) statistics.restore(meta.collisionSums, meta.impactSpeeds.toLongArray())
                val seconds = meta?.wallSeconds ?: 0.0
                val lengths = meta?.fileLengths
                return Run(directory, scenario, simulation, sums(setup), transport(setup), statistics, lengths, seconds, lock, notices)
            } catch (e: RuntimeException) {
                lock.close()
                throw e
            } catch (e: IOException) {
                lock.close()
                throw RunException("cannot write to $path: ${RunDirectory.reason(e)}")
            }
        }

        /** A time that is past cannot be an end; the last step may have fallen on either side of it by round-off. */
        private fun checkLater(until: Double, now: Double, scenario: Scenario) {
            val step = scenario.timeStep
            val slack = if (step is TimeStepSpec.Fixed) step.dt * END_SLACK else 0.0
            if (until < now - slack) throw InputException("--until", null, "is $until; the run is at time $now, give a later end")
        }

        private fun lastGood(directory: RunDirectory, notices: MutableList<String>): Checkpoint? {
            val files = listOf(directory.checkpoint, directory.previousCheckpoint).filter { Files.exists(it) }
            for (file in files) {
                try {
                    return Checkpoint.read(file).also { if (notices.isNotEmpty()) notices += "going on from $file, step ${it.meta.step}" }
                } catch (e: OtherVersionException) {
                    throw InputException("", null, e.message.orEmpty())
                } catch (e: CheckpointException) {
                    notices += e.message.orEmpty()
                }
            }
            if (files.isEmpty()) return null
            throw InputException("", null, notices.joinToString("; ") + "; no checkpoint is left to go on from, run the scenario again")
        }

        private fun sums(setup: ScenarioSetup): PopulationSums {
            val leastBody = setup.scenario.firstBody ?: Int.MAX_VALUE
            return PopulationSums(setup.boundary.meanFlow, setup.angularSpeed, leastBody)
        }

        private fun transport(setup: ScenarioSetup): TransportRows? = if (setup.scenario.output.transportEvery == 0) {
            null
        } else {
            TransportRows(setup.forces.filterIsInstance<SelfGravity>().firstOrNull())
        }

        private fun simulation(setup: ScenarioSetup, meta: CheckpointMeta?, source: String, engines: EngineFactory): Simulation {
            val engine = engineOf(setup.scenario, source, engines)
            val output = setup.scenario.output
            val records = output.collisionLog || output.transportEvery > 0
            val forcing = CollisionForcing(setup.restitution, setup.guard, engine, records, setup.scenario.search)
            if (meta != null) {
                forcing.counters.collisions = meta.collisions
                forcing.counters.wallCollisions = meta.wallCollisions
                forcing.counters.guardActivations = meta.guardActivations
                forcing.counters.redoneSteps = meta.redoneSteps
                forcing.counters.causalityReplays = meta.causalityReplays
            }
            val start = setup.scenario.startTime
            return Simulation(
                setup.population,
                setup.boundary,
                forcing,
                setup.timeStep,
                setup.forces,
                startTime = meta?.time ?: start,
                startStep = meta?.step ?: 0,
                runStart = start,
            )
        }
    }
}
