package daphnis.core.run

import daphnis.core.format.FormatException
import daphnis.core.format.Snapshot
import daphnis.core.input.InputException
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import java.nio.file.Files
import kotlin.math.abs

/**
 * The states of a run in a run directory, from [Run.open]: its snapshots, and the state of its last checkpoint. One
 * state is in memory at a time. The run may go on meanwhile; every call sees the states that are there then, each of
 * them complete. Any thread may call.
 *
 * Lengths, times and masses are in the scenario's units. The functions throw [FormatException] for a snapshot that is
 * damaged and [InputException] for a checkpoint that is, or for a directory that cannot be read.
 */
public class RecordedRun internal constructor(public val directory: RunDirectory) {
    init {
        directory.requireRun()
    }

    /** The scenario that is run, as the directory has it now; null for a [Program]. */
    public fun scenario(): Scenario? =
        if (Files.exists(directory.scenario)) ScenarioJson.read(directory.scenario).atHome(directory.path) else null

    /** Result of the run, which is what the run wrote; null while it has none. */
    public fun summary(): Summary? {
        if (!Files.exists(directory.summary)) return null
        RunRecord.of(directory).problems(directory.summary).firstOrNull()?.let { throw FormatException(it) }
        return Summary.read(directory.summary)
    }

    /** Steps after which there is a state, ascending. */
    public fun steps(): List<Long> {
        // First: what was written before a checkpoint is there when the checkpoint is.
        val last = checkpoint.lastStep()
        return (directory.snapshotSteps() + listOfNotNull(last)).distinct().sorted()
    }

    /**
     * Every state in the order of time, each read when the iterator comes to it. An iterator goes through the snapshots
     * up to the last checkpoint that is there when it comes to its end, and then that checkpoint if it is of a later
     * step. In Kotlin `asSequence()` makes chains of calls lazy too.
     */
    public fun states(): Iterable<Snapshot> = Iterable {
        iterator {
            var last = -1L
            for (step in directory.snapshotSteps()) {
                yield(directory.readSnapshot(step))
                last = step
            }
            val step = checkpoint.lastStep() ?: return@iterator
            // Those that a run has written meanwhile.
            for (later in directory.snapshotSteps()) {
                if (later <= last || later > step) continue
                yield(directory.readSnapshot(later))
                last = later
            }
            if (step > last) checkpoint.read(step)?.let { yield(it) }
        }
    }

    /** The latest state. @throws InputException when the run has none */
    public fun last(): Snapshot = atStep(steps().lastOrNull() ?: none("has no state yet"))

    /** The state after [step] steps. @throws InputException when there is none; the message says which there are */
    public fun atStep(step: Long): Snapshot {
        if (Files.exists(directory.snapshot(step))) return directory.readSnapshot(step)
        return checkpoint.read(step) ?: none("has no state after step $step; it has ${there { "$it" }}")
    }

    /**
     * The state at [time], which must be that of a state but for round-off, 1e-9 of it.
     *
     * @throws InputException when there is none; the message says which are next to it
     */
    public fun at(time: Double): Snapshot {
        val steps = steps()
        if (steps.isEmpty()) none("has no state yet")
        // The last state that is not later than time, or the first one.
        var low = 0
        var high = steps.lastIndex
        var found = atStep(steps[0])
        while (low < high) {
            val middle = (low + high + 1) / 2
            val state = atStep(steps[middle])
            if (state.time <= time || isSame(state.time, time)) {
                low = middle
                found = state
            } else {
                high = middle - 1
            }
        }
        if (isSame(found.time, time)) return found
        val next = steps.getOrNull(low + 1)?.takeIf { found.time < time }?.let { atStep(it) }
        val near = listOfNotNull(found, next).joinToString(" and ") { "step ${it.step}, ${inWords(it.time)}" }
        none("has no state at ${inWords(time)}; next to it are those of $near")
    }

    private fun inWords(time: Double): String = TimeWords.of(scenario(), directory.scenario.toString()).text(time)

    private val checkpoint get() = CheckpointState(directory)

    private fun isSame(one: Double, other: Double) = abs(one - other) <= SAME * maxOf(abs(one), abs(other))

    /** All steps, or the range and number of many. */
    private fun there(say: (Long) -> String): String {
        val steps = steps()
        if (steps.isEmpty()) return "none"
        if (steps.size <= MOST_NAMED) return steps.joinToString { say(it) }
        return "${steps.size}, from ${say(steps[0])}, ${say(steps[1])}, … to ${say(steps.last())}"
    }

    private fun none(problem: String): Nothing = throw InputException("${directory.path}", null, problem)

    private companion object {
        const val SAME = 1e-9
        const val MOST_NAMED = 10
    }
}
