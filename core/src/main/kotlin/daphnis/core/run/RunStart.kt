package daphnis.core.run

import daphnis.core.engine.EngineFactory
import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.InputException
import daphnis.core.scenario.RunTimes
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.scenario.TimeStepSpec
import daphnis.core.scenario.warnings
import daphnis.core.scenario.wrongArgument
import java.io.IOException
import java.nio.file.Files

/** Makes the initial state and the engine, then the directory: input that is refused leaves everything as it was. */
internal fun startRun(
    scenario: Scenario,
    source: String,
    directory: RunDirectory,
    force: Boolean,
    engines: EngineFactory,
): Run {
    val setup = ScenarioSetup.of(scenario, source)
    val parts = RunParts(setup, null, source, engines)
    var lock: AutoCloseable? = null
    try {
        val place = NewRun(directory, force)
        lock = place.claim()
        val resolved = place.begin(setup.scenario)
        val notices = setup.notices + warnings(setup)
        return Run(
            directory,
            resolved,
            ScenarioJson.write(resolved),
            parts,
            Checkpoints(directory),
            null,
            lock,
            notices,
        )
    } catch (e: IOException) {
        parts.simulation.use { lock?.close() }
        throw cannotWrite(directory, e)
    } catch (e: Throwable) {
        parts.simulation.use { lock?.close() }
        throw e
    }
}

/** Goes on from the last good checkpoint; see [Run.resume]. */
internal fun resumeRun(directory: RunDirectory, until: Double?, engines: EngineFactory, acceptLoss: Boolean): Run {
    directory.requireRun()
    val lock = RunLock.take(directory.path)
    try {
        // Once more: another process may have replaced it before the lock was taken.
        directory.requireRun()
        return resumed(directory, until, engines, acceptLoss, lock)
    } catch (e: IOException) {
        lock.close()
        throw cannotWrite(directory, e)
    } catch (e: Throwable) {
        lock.close()
        throw e
    }
}

private fun resumed(
    directory: RunDirectory,
    until: Double?,
    engines: EngineFactory,
    acceptLoss: Boolean,
    lock: AutoCloseable,
): Run {
    val read = ScenarioJson.read(directory.scenario)
    val scenario = read.atHome(directory.path).let { it.copy(until = until ?: it.until) }
    if (until != null && !(until > read.startTime && until.isFinite())) {
        throw wrongArgument(UNTIL, null, "is $until; it must be > ${read.startTime}")
    }
    val notices = ArrayList<String>()
    val checkpoints = Checkpoints(directory)
    val good = checkpoints.lastGood(acceptLoss, notices)
    val checkpoint = good?.checkpoint
    val changes = checkSame(directory, checkpoint, read, notices)
    val now = checkpoint?.meta?.time ?: 0.0
    val source = directory.scenario.toString()
    val times = FrameSetup.times(scenario, source)
    if (until != null) {
        checkLater(until, now, times) { wrongArgument(UNTIL, null, it) }
    } else if (changes.harmless.any { it.startsWith("until") }) {
        checkLater(times.end, now, times) { InputException(source, "until", it) }
    }
    val setup = ScenarioSetup.of(scenario, source, checkpoint?.population)
    val parts = RunParts(setup, checkpoint?.meta, source, engines)
    try {
        // Snapshots after the checkpoint are written again, to the same bits; the summary is of a run that goes on.
        Files.deleteIfExists(directory.summary)
        Files.createDirectories(directory.snapshots)
    } catch (e: IOException) {
        parts.simulation.close()
        throw e
    }
    return Run(directory, setup.scenario, ScenarioJson.write(read), parts, checkpoints, good, lock, notices)
}

/** Another scenario would go on from the checkpoint to a run that never was. */
private fun checkSame(
    directory: RunDirectory,
    checkpoint: Checkpoint?,
    scenario: Scenario,
    notices: MutableList<String>,
): ScenarioChanges {
    val changes = ScenarioChanges.between(checkpoint?.scenario, scenario)
    changes.essential.firstOrNull()?.let {
        val mend = "take the change back, or run the changed scenario into another directory"
        throw InputException(directory.scenario.toString(), null, "$it; $mend")
    }
    for (change in changes.harmless) notices += "${directory.scenario}: $change"
    return changes
}

/** A time that is past cannot be an end; the last step may have fallen on either side of it by round-off. */
private fun checkLater(until: Double, now: Double, times: RunTimes, refusal: (String) -> InputException) {
    if (until >= now - endSlack(times.timeStep)) return
    throw refusal("is $until; the run is at time $now, give a later end")
}

/** A whole number of fixed steps can fall short of the end by round-off; so much is no other step. */
internal fun endSlack(timeStep: TimeStepSpec): Double =
    (timeStep as? TimeStepSpec.Fixed)?.let { it.dt * END_SLACK } ?: 0.0

internal fun cannotWrite(directory: RunDirectory, e: IOException): RunException =
    RunException("cannot write to ${directory.path}: ${reasonOf(e)}")

private const val UNTIL = "until"
private const val END_SLACK = 1e-6
