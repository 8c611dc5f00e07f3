package daphnis.core.run

import daphnis.core.OutputState
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import java.nio.file.Files
import java.nio.file.Path

/**
 * A checkpoint from which a run can continue.
 *
 * @property beginnings of the files to which it appends, by name
 * @property losses what was lost of them and accepted, now or earlier, one line each
 */
internal class GoodCheckpoint(
    val checkpoint: Checkpoint,
    val beginnings: Map<String, Beginning>,
    accepted: List<String> = emptyList(),
) {
    val losses: List<String> = checkpoint.meta.losses + accepted
}

/**
 * The two checkpoints of a run directory. A new one is written completely beside them. Then the last one becomes the
 * previous one, and then the new one becomes the last. At every moment one of them is good: when the program is killed
 * between the two moves, there is the previous one. A checkpoint that was found damaged does not replace the previous
 * one.
 */
internal class Checkpoints(private val directory: RunDirectory) {
    private val files = directory.files
    private var isLastGood = false

    /** @param saved what outputs have saved, by name */
    fun write(meta: CheckpointMeta, scenario: String, spheres: SpheresById, saved: Map<String, OutputState>) {
        files.writeWhole(directory.newCheckpoint) { Checkpoint.write(meta, scenario, spheres, saved, it) }
        if (isLastGood) files.move(directory.checkpoint, directory.previousCheckpoint)
        files.move(directory.newCheckpoint, directory.checkpoint)
        files.forceDirectory(directory.path)
        isLastGood = true
    }

    /**
     * The last checkpoint that is intact and agrees with the appended files; null when there never was one.
     *
     * @param acceptLoss when the files agree with none, to continue from the last intact one with what they hold
     * @param notices receives one line for each thing skipped or lost
     * @throws InputException when none can be used
     */
    fun lastGood(acceptLoss: Boolean, notices: MutableList<String>): GoodCheckpoint? {
        val found = listOf(directory.checkpoint, directory.previousCheckpoint).filter { Files.exists(it) }
        if (found.isEmpty()) {
            requireUnbegun(acceptLoss, notices)
            return null
        }
        for (file in found) requireFile(file)
        val problems = ArrayList<String>()
        val readable = ArrayList<Readable>()
        for (file in found) {
            val one = read(file, problems) ?: continue
            if (one.appended.problems.isEmpty()) return taken(one, emptyList(), problems, notices)
            problems += one.appended.problems
            readable += one
        }
        val last = readable.firstOrNull()
        if (last == null) {
            val mend = "no usable checkpoint is left, run the scenario again"
            throw InputException("", null, "${problems.joinToString("; ")}; $mend")
        }
        if (!acceptLoss) throw InputException("", null, problems.first(), WayOut.RESUME_WITH_LOSS)
        return taken(last, last.appended.acceptLoss(), emptyList(), notices)
    }

    /** An intact checkpoint, and how it agrees with the appended files. */
    private class Readable(val file: Path, val checkpoint: Checkpoint, val appended: AppendedCheck)

    /** Nothing could replace what is no file. */
    private fun requireFile(path: Path) {
        if (Files.isRegularFile(path)) return
        throw InputException("$path", null, "is not a file; remove it and resume again")
    }

    /** The checkpoint in [file]; null when it is damaged, and [problems] get the reason. */
    private fun read(file: Path, problems: MutableList<String>): Readable? {
        val checkpoint = try {
            Checkpoint.read(file)
        } catch (e: CheckpointException) {
            problems += e.message.orEmpty()
            return null
        }
        return Readable(file, checkpoint, AppendedCheck(directory, checkpoint.meta))
    }

    /**
     * A run has a checkpoint as soon as its start has been written. A run that has written more and has none has lost
     * it.
     */
    private fun requireUnbegun(acceptLoss: Boolean, notices: MutableList<String>) {
        if (!Files.exists(directory.summary) && directory.snapshotSteps().none { it > 0 }) return
        val other = directory.previousCheckpoint.fileName
        val missing = "${directory.checkpoint} and $other are both missing, but the run has already written output"
        if (!acceptLoss) {
            throw InputException("", null, missing, WayOut.BEGIN_ANEW)
        }
        notices += "$missing; it starts again from the beginning"
    }

    private fun taken(
        one: Readable,
        accepted: List<String>,
        problems: List<String>,
        notices: MutableList<String>,
    ): GoodCheckpoint {
        val good = GoodCheckpoint(one.checkpoint, one.appended.beginnings, accepted)
        notices += problems + good.losses.map { "${directory.path}/$it" }
        if (notices.isNotEmpty()) notices += "going on from ${one.file}, step ${good.checkpoint.meta.step}"
        if (good.checkpoint.scenario == null) {
            notices += "${one.file}: is of format 2, without checksums of scenario and tables; they are not checked"
        }
        isLastGood = one.file == directory.checkpoint
        return good
    }
}
