package daphnis.core.run

import daphnis.core.FixedTimeStep
import daphnis.core.Output
import daphnis.core.TimeStep
import daphnis.core.engine.EngineFactory
import daphnis.core.format.reasonOf
import daphnis.core.input.InputException
import daphnis.core.input.ValueCheck
import daphnis.core.input.wrongArgument
import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.GrowthSetup
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.scenario.TimeStepSpec
import daphnis.core.scenario.warnings
import java.io.IOException
import java.nio.file.Files

/**
 * Makes the initial state and the engine first and then the directory, so input that is refused leaves everything as it
 * was.
 */
internal fun startRun(
    scenario: Scenario,
    source: String,
    directory: RunDirectory,
    force: Boolean,
    engines: EngineFactory,
    own: Map<String, Output> = emptyMap(),
    from: RunOrigin? = null,
): Run {
    val start = from?.let { OriginCheck(scenario, source, it).start() } ?: scenario
    val setup = ScenarioSetup.of(start, source, null, from?.start)
    val notices = from?.notices(scenario).orEmpty() + setup.notices + warnings(setup)
    val plan = planOf(setup, null, source, engines, own)
    return begun(directory, force, plan, notices) { ScenarioJson.write(it.begin(setup.scenario, from?.start)) }
}

/** A run of [plan] in a directory into which [begin] writes. Closes the plan when it throws. */
internal inline fun begun(
    directory: RunDirectory,
    force: Boolean,
    plan: RunPlan,
    notices: List<String>,
    begin: (NewRun) -> String,
): Run {
    var lock: RunLock? = null
    try {
        val place = NewRun(directory, force)
        lock = place.claim()
        val origin = begin(place)
        return Run(directory, plan, origin, Checkpoints(directory), null, lock, listOfNotNull(lock.notice) + notices)
    } catch (e: IOException) {
        plan.use { lock.use { throw cannotWrite(directory, e) } }
    } catch (e: Throwable) {
        plan.use { lock.use { throw e } }
    }
}

/** Continues from the last good checkpoint; see [Run.resume]. */
internal fun resumeRun(
    directory: RunDirectory,
    until: Double?,
    engines: EngineFactory,
    acceptLoss: Boolean,
    own: Map<String, Output> = emptyMap(),
): Run = locked(directory, RunDirectory::requireScenario) { lock ->
    resumed(directory, until, engines, acceptLoss, own, lock)
}

/** Calls [resume] with [directory] under its lock; [require] checks what must be there. */
internal inline fun locked(
    directory: RunDirectory,
    require: (RunDirectory) -> Unit,
    resume: (lock: RunLock) -> Run,
): Run {
    require(directory)
    val lock = RunLock.take(directory.path)
    try {
        // Checked again, since another process may have replaced it before the lock was taken.
        require(directory)
        return resume(lock)
    } catch (e: IOException) {
        lock.use { throw cannotWrite(directory, e) }
    } catch (e: Throwable) {
        lock.use { throw e }
    }
}

private fun resumed(
    directory: RunDirectory,
    until: Double?,
    engines: EngineFactory,
    acceptLoss: Boolean,
    own: Map<String, Output>,
    lock: RunLock,
): Run {
    val found = ScenarioJson.read(directory.scenario)
    val written = withEnd(until, found)
    val scenario = written.atHome(directory.path)
    val notices = ArrayList<String>()
    val checkpoints = Checkpoints(directory)
    val good = checkpoints.lastGood(acceptLoss, notices)
    val checkpoint = good?.checkpoint
    val changes = checkSame(directory, checkpoint, found, notices)
    val source = directory.scenario.toString()
    requireLaterEnd(until, changes, scenario, checkpoint?.meta?.time ?: 0.0, source)
    val setup = ScenarioSetup.of(scenario, source, checkpoint?.population)
    checkpoint?.let {
        val step = setup.timeStep.next(setup.population)
        GrowthSetup(scenario, ValueCheck(source))
            .checkEnd(setup.population, setup.boundary.box, step, it.meta.time, setup.scenario.end)
    }
    val plan = planOf(setup, checkpoint?.meta, source, engines, own)
    val text = ScenarioJson.write(written)
    return goingOn(directory, plan, text, checkpoints, good, lock, notices) {
        // From here on this is the run of the new end, also for one who resumes it when it is killed before that.
        if (written != found) directory.files.writeAtomically(directory.scenario) { Files.writeString(it, text) }
    }
}

/** [scenario] with the end [until] in place of its own, unless that is null; as it would be if begun with this end. */
private fun withEnd(until: Double?, scenario: Scenario): Scenario {
    if (until == null) return scenario
    if (until > scenario.startTime && until.isFinite()) {
        val description = scenario.description.replace(CHANGED_END) { "${it.groupValues[1]}$UNTIL=$until" }
        return scenario.copy(until = until, untilOrbits = null, description = description)
    }
    throw wrongArgument(UNTIL, null, "is $until; it must be > ${scenario.startTime}")
}

/** Refuses an end that has passed, whether it is given now or has been written into the scenario since. */
private fun requireLaterEnd(
    until: Double?,
    changes: ScenarioChanges,
    scenario: Scenario,
    now: Double,
    source: String,
) {
    val times = FrameSetup.times(scenario, source)
    val slack = endSlack(times.timeStep)
    val words = TimeWords.of(scenario, source)
    if (until != null) {
        checkLater(until, now, slack, words) { wrongArgument(UNTIL, null, it) }
    } else if (changes.harmless.any { it.startsWith(UNTIL) }) {
        checkLater(times.end, now, slack, words) { InputException(source, UNTIL, it) }
    }
}

/**
 * A run of [plan] that continues from [good]. Closes the plan when it throws, but not the [lock].
 *
 * @param origin text of the scenario or program, for checkpoints
 * @param keep writes what is new in the directory, when the summary of an earlier end is gone
 */
internal fun goingOn(
    directory: RunDirectory,
    plan: RunPlan,
    origin: String,
    checkpoints: Checkpoints,
    good: GoodCheckpoint?,
    lock: RunLock,
    notices: MutableList<String>,
    keep: () -> Unit = {},
): Run {
    try {
        notices += listOfNotNull(lock.notice)
        if (good != null) giveBack(plan.own, good.checkpoint, directory, notices)
        for (folder in directory.folders) directory.files.requireWritable(folder)
        // Snapshots after the checkpoint are written again, with the same bits; the summary would be that of a run
        // which has not ended.
        directory.files.delete(directory.summary)
        keep()
        return Run(directory, plan, origin, checkpoints, good, lock, notices)
    } catch (e: Throwable) {
        plan.use { throw e }
    }
}

/** Gives a program's own outputs what they saved, and reports which had saved nothing and which are gone. */
private fun giveBack(
    own: Map<String, Output>,
    checkpoint: Checkpoint,
    directory: RunDirectory,
    notices: MutableList<String>,
) {
    restore(own, checkpoint.outputs)
    for (name in checkpoint.outputs.keys - own.keys - PeriodicOutputs.names) {
        notices += "${directory.path}: output '$name' is no longer there; what it had saved is dropped"
    }
}

/** Another scenario would continue from the checkpoint to a run that never existed. */
private fun checkSame(
    directory: RunDirectory,
    checkpoint: Checkpoint?,
    scenario: Scenario,
    notices: MutableList<String>,
): ScenarioChanges {
    val changes = ScenarioChanges.between(checkpoint?.scenario, scenario)
    changes.essential.firstOrNull()?.let {
        val mend = "undo the change, or run the changed scenario into another directory"
        throw InputException(directory.scenario.toString(), null, "$it; $mend")
    }
    for (change in changes.harmless) notices += "${directory.scenario}: $change"
    return changes
}

/** A time in the past cannot be the end; by round-off the last step may be on either side of it. */
internal fun checkLater(
    until: Double,
    now: Double,
    slack: Double,
    words: TimeWords,
    refusal: (String) -> InputException,
) {
    if (until >= now - slack) return
    val (end, present) = listOf(until, now).map(words::text)
    throw refusal(
        if (end == present) {
            "is $until; the run is at time $now, give a later end"
        } else {
            "is $end; the run is at $present, give a later end"
        },
    )
}

/** A whole number of fixed steps can fall short of the end by round-off; this amount does not require another step. */
internal fun endSlack(timeStep: TimeStepSpec): Double = timeStep.dt?.let { it * END_SLACK } ?: 0.0

/** The same for a [TimeStep]. */
internal fun endSlack(step: TimeStep): Double = if (step is FixedTimeStep) step.duration * END_SLACK else 0.0

internal fun cannotWrite(directory: RunDirectory, e: IOException): RunException =
    RunException("cannot write to ${directory.path}: ${reasonOf(e, directory.path)}", e)

private const val UNTIL = "until"

/** The end among what the command line changed of a scenario, which it says behind the description. */
private val CHANGED_END = Regex("""(; changed: (?:.*, )?)(?:until|untilOrbits|steps)=[^,;]*""")
private const val END_SLACK = 1e-6
