package daphnis.core.run

import daphnis.core.OutputState
import daphnis.core.population.Population
import daphnis.core.scenario.InputException
import daphnis.core.scenario.WayOut
import java.nio.file.Files
import java.nio.file.Path

/**
 * A checkpoint that a run can go on from.
 *
 * @property beginnings of the files that it appends to, by name
 * @property losses what was lost of them and accepted, now or earlier, a line each
 */
internal class GoodCheckpoint(
    val checkpoint: Checkpoint,
    val beginnings: Map<String, Beginning>,
    accepted: List<String> = emptyList(),
) {
    val losses: List<String> = checkpoint.meta.losses + accepted
}

/**
 * The two checkpoints of a run directory. A new one is written whole beside them; then the last becomes the previous
 * one, then the new one the last. At every moment one of them is good: killed between the two moves, there is the
 * previous one. One that was found damaged is not kept in place of the previous one.
 */
internal class Checkpoints(private val directory: RunDirectory) {
    private val files = directory.files
    private var isLastGood = false

    /** @param saved what outputs have saved, by name */
    fun write(meta: CheckpointMeta, scenario: String, population: Population, saved: Map<String, OutputState>) {
        val own = saved - RunOutputs.TRANSPORT
        files.writeWhole(directory.newCheckpoint) { Checkpoint.write(meta, scenario, population, own, it) }
        if (isLastGood) files.move(directory.checkpoint, directory.previousCheckpoint)
        files.move(directory.newCheckpoint, directory.checkpoint)
        files.forceDirectory(directory.path)
        isLastGood = true
    }

    /**
     * The last checkpoint that is whole and that the files appended to agree with; null when there never was one.
     *
     * @param acceptLoss when the files agree with none, to go on from the last one that is whole with what they hold
     * @param notices gets a line for each thing passed over or lost
     * @throws InputException when none can be used
     */
    fun lastGood(acceptLoss: Boolean, notices: MutableList<String>): GoodCheckpoint? {
        val found = listOf(directory.checkpoint, directory.previousCheckpoint).filter { Files.exists(it) }
        if (found.isEmpty()) {
            requireUnbegun(acceptLoss, notices)
            return null
        }
        // Nothing could take its place.
        found.find {
            !Files.isRegularFile(it)
        }?.let { throw InputException("$it", null, "is no file; take it away, and resume again") }
        val problems = ArrayList<String>()
        val whole = ArrayList<Pair<Path, Checkpoint>>()
        for (file in found) {
            val checkpoint = try {
                Checkpoint.read(file)
            } catch (e: CheckpointException) {
                problems += e.message.orEmpty()
                continue
            }
            whole += file to checkpoint
            val appended = AppendedCheck(directory, checkpoint.meta)
            problems += appended.problems
            if (appended.problems.isNotEmpty()) continue
            return taken(file, GoodCheckpoint(checkpoint, appended.beginnings), problems, notices)
        }
        if (whole.isEmpty()) {
            val mend = "no checkpoint is left to go on from, run the scenario again"
            throw InputException("", null, "${problems.joinToString("; ")}; $mend")
        }
        if (!acceptLoss) {
            throw InputException("", null, problems.first(), WayOut.RESUME_WITH_LOSS)
        }
        val (file, checkpoint) = whole.first()
        val appended = AppendedCheck(directory, checkpoint.meta)
        return taken(file, GoodCheckpoint(checkpoint, appended.beginnings, appended.acceptLoss()), emptyList(), notices)
    }

    /** A run has a checkpoint as soon as its start has been written; one that has gone on and has none has lost it. */
    private fun requireUnbegun(acceptLoss: Boolean, notices: MutableList<String>) {
        if (!Files.exists(directory.summary) && directory.snapshotSteps().none { it > 0 }) return
        val other = directory.previousCheckpoint.fileName
        val missing = "${directory.checkpoint}: is missing, and so is $other, though the run has gone on"
        if (!acceptLoss) {
            throw InputException("", null, missing, WayOut.BEGIN_ANEW)
        }
        notices += "$missing; it begins anew"
    }

    private fun taken(
        file: Path,
        good: GoodCheckpoint,
        problems: List<String>,
        notices: MutableList<String>,
    ): GoodCheckpoint {
        notices += problems + good.losses.map { "${directory.path}/$it" }
        if (notices.isNotEmpty()) notices += "going on from $file, step ${good.checkpoint.meta.step}"
        if (good.checkpoint.scenario == null) {
            notices += "$file: is of format 2, without checksums of scenario and tables; they are not checked"
        }
        isLastGood = file == directory.checkpoint
        return good
    }
}
