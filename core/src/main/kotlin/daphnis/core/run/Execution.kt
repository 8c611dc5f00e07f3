package daphnis.core.run

import daphnis.core.FixedTimeStep
import daphnis.core.Opening
import daphnis.core.OutputState
import daphnis.core.cluster.FleetException
import daphnis.core.collision.CollisionCounters
import daphnis.core.step.CollapseException
import daphnis.core.step.CollisionStep
import daphnis.core.wall.pistons
import java.io.IOException
import java.util.function.BooleanSupplier

/** The run between the first call of the outputs and the last. */
internal class Execution(
    private val directory: RunDirectory,
    private val plan: RunPlan,
    private val origin: String,
    private val checkpoints: Checkpoints,
    private val from: GoodCheckpoint?,
    private val files: RunFiles,
    private val outputs: RunOutputs,
) {
    private val simulation = plan.simulation
    private val copies = checkpointTimes(plan.output)
    private val resumedFrom = simulation.step
    private val secondsBefore = from?.checkpoint?.meta?.wallSeconds ?: 0.0
    private val begin = System.nanoTime()
    private fun seconds() = secondsBefore + (System.nanoTime() - begin) * 1e-9

    private fun isDone(): Boolean = simulation.time >= plan.until - plan.endSlack || plan.isOver()

    /** Advances to the end, as [Run.execute] says. */
    fun carryOut(cancelled: BooleanSupplier): Summary = try {
        toTheEnd(cancelled)
    } catch (e: Throwable) {
        throw firstOf(e)
    } finally {
        simulation.collisions?.toCome = CollisionStep.UNKNOWN
    }

    /** What was handed over to the writer before [e] was thrown comes before [e], and so does its failure. */
    private fun firstOf(e: Throwable): Throwable = try {
        files.writer.await()
        e
    } catch (earlier: Throwable) {
        if (earlier !== e) earlier.addSuppressed(e)
        earlier
    }

    private fun toTheEnd(cancelled: BooleanSupplier): Summary {
        outputs.open(simulation, if (from == null) Opening.START else Opening.RESUME)
        if (from == null) {
            show()
            checkpoint(0.0)
        }
        var finished = isDone()
        while (!finished && !cancelled.asBoolean) {
            advance()
            show()
            files.flushIfDue()
            files.writer.check()
            finished = isDone()
            if (!finished && copies.isDue(simulation)) checkpoint(seconds())
        }
        files.writer.await()
        if (finished) outputs.finish(simulation)
        val summary = Summary.of(plan, finished, seconds())
        checkpoint(summary.wallSeconds, summary)
        files.writer.rows(0) { summary.write(directory) }
        files.writer.await()
        return summary
    }

    /** The outputs look at the state, and cannot change it meanwhile. */
    private fun show() {
        simulation.hold { outputs.write(simulation) }
    }

    /** The longest step so far; those that end at a stop are shorter. */
    private var longest = (simulation.timeStep as? FixedTimeStep)?.duration ?: 0.0

    /** Steps after the next one, if they are as long as the longest one; none before there is one. */
    private fun stepsToCome(): Long {
        longest = maxOf(longest, simulation.lastDuration)
        if (longest == 0.0) return 0
        return maxOf(0, Math.round((plan.until - simulation.time) / longest) - 1)
    }

    /**
     * One step. When it fails, the state before it is kept as a checkpoint; not of a [Program], whose functions may
     * have changed what they save.
     */
    private fun advance() {
        try {
            simulation.collisions?.toCome = stepsToCome()
            simulation.advance()
        } catch (e: IOException) {
            // From an output: the disk is the cause, and nothing more can be written.
            throw e
        } catch (e: FleetException) {
            // Without nodes the state before cannot be had, and at the first step this has nothing to do with it.
            val step = if (simulation.step == resumedFrom) "" else "step ${simulation.step + 1}: "
            throw RunException("$step${e.message}", e)
        } catch (e: Exception) {
            keepStateBefore(e)
            throw RunException("step ${simulation.step + 1}: ${reason(e)}", e)
        } catch (e: Error) {
            keepStateBefore(e)
            throw e
        }
    }

    /**
     * Spheres that grow and collide without end, or fail otherwise at a high pressure, are jammed, and the state is
     * still that before the step.
     */
    private fun reason(e: Exception): String {
        val said = e.message ?: e.javaClass.name
        val growth = simulation.boundary.growth
        val pressure = growth?.reducedPressure ?: Double.NaN
        if (growth == null || e !is CollapseException && !(pressure > JAMMED)) return said
        val filling = growth.fillingFactor(simulation.population)
        return "jammed at a filling factor of $filling and a reduced pressure of $pressure ($said); end the run " +
            "before, with growth.untilFillingFactor or growth.untilPressure"
    }

    private fun keepStateBefore(e: Throwable) {
        if (plan.scenario == null) return
        firstOf(e).let { if (it !== e) throw it }
        try {
            checkpoint(seconds())
            files.writer.await()
        } catch (another: Throwable) {
            // A full disk, or no memory for it; what ended the step matters more.
            if (another !== e) e.addSuppressed(another)
        }
    }

    /** @param summary of a run that ends here, whose mark is in the checkpoint before the summary is written */
    private fun checkpoint(wallSeconds: Double, summary: Summary? = null) {
        val saved = outputs.save()
        files.flush()
        val last = listOfNotNull(summary?.let { RunDirectory.SUMMARY to FileMark.of(it.bytes()) })
        val meta = CheckpointMeta(
            simulation.step,
            simulation.time,
            CheckpointMeta.counted(simulation.collisions?.counters ?: CollisionCounters()),
            wallSeconds,
            losses = from?.losses.orEmpty(),
            reducedPressure = simulation.boundary.growth?.reducedPressure?.takeIf { it.isFinite() },
            pistons = simulation.boundary.walls.pistons.mapValues { (_, it) -> it.carried.asList() },
            forces = CheckpointMeta.carried(simulation.forces),
        )
        val population = simulation.population
        files.writer.state(SpheresById.bytes(population), { SpheresById(population) }) { spheres ->
            write(meta, last, spheres, saved)
        }
    }

    /** By the writer: what the checkpoint vouches for is on the disk before it. */
    private fun write(
        meta: CheckpointMeta,
        last: List<Pair<String, FileMark>>,
        spheres: SpheresById,
        saved: Map<String, OutputState>,
    ) {
        try {
            checkpoints.write(meta.with(files.force(), files.whole + last, files.snapshots), origin, spheres, saved)
        } catch (e: IllegalStateException) {
            throw failed(e, meta.step)
        } catch (e: IllegalArgumentException) {
            throw failed(e, meta.step)
        }
    }
}

/** Reduced pressure at which growing spheres are jammed when a step fails. */
private const val JAMMED = 100.0

/** What a run throws for [e], which names no step. */
internal fun failed(e: RuntimeException, step: Long) = RunException("step $step: ${e.message}", e)
