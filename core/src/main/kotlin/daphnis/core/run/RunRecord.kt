package daphnis.core.run

import daphnis.core.scenario.Scenario
import java.nio.file.Files
import java.nio.file.Path

/**
 * What the checkpoint of a run knows of the run's other files. Readers compare the files with it and so find files that
 * were damaged or edited since. Nothing is known of a run without a readable checkpoint, or with one of format 2.
 */
public class RunRecord private constructor(
    private val directory: RunDirectory,
    private val head: Checkpoint.Head?,
    private val isLast: Boolean,
) {
    /** Whether the last step of the run has been made, and perhaps no other since. */
    public val hasEnded: Boolean get() = isLast && RunDirectory.SUMMARY in head?.meta?.whole.orEmpty()

    /** The checksum of the state after each [step][Long] up to the checkpoint that the run wrote as a snapshot. */
    internal val snapshots: Map<Long, Long> get() = head?.meta?.snapshots.orEmpty()

    /**
     * What is wrong with [files] of the directory, including missing ones: one line each, with the file's name. Rows
     * that were written after the checkpoint are not checked. Summary and impacts are known once the run has ended.
     */
    public fun problems(vararg files: Path): List<String> {
        val meta = head?.meta ?: return emptyList()
        // While a run is in progress, impacts are written before the checkpoint that knows them.
        val whole = if (hasEnded && Files.exists(directory.summary)) meta.whole else emptyMap()
        return files.mapNotNull { file ->
            val name = file.fileName.toString()
            val problem = meta.appended[name]?.problem(file) ?: whole[name]?.problem(file, whole = true)
            problem?.let { "$file: $it" }
        }
    }

    /**
     * Whether [file], which a run that has not ended writes whole before each checkpoint, is another than that of the
     * last one. Then the run has gone on since, was killed between the two, or the file is of another run.
     */
    public fun isNewer(file: Path): Boolean =
        !hasEnded && head?.meta?.whole?.get(file.fileName.toString())?.problem(file, whole = true) != null

    /** What was lost of the tables and accepted when the run was resumed, one line each. */
    public val losses: List<String> get() = head?.meta?.losses.orEmpty().map { "${directory.path}/$it" }

    /** Where [scenario], read from the directory, would make another run than the one that is there, one line each. */
    public fun changes(scenario: Scenario): List<String> =
        compare(scenario).essential.map { "${directory.scenario}: $it" }

    /** The other differences of [scenario] from the one with which the run was made, one line each. */
    public fun harmlessChanges(scenario: Scenario): List<String> =
        compare(scenario).harmless.map { "${directory.scenario}: $it" }

    private fun compare(scenario: Scenario) = ScenarioChanges.between(head?.scenario, scenario)

    public companion object {
        /** Reads the beginning of the last checkpoint of [directory] that has a readable one. */
        @JvmStatic
        public fun of(directory: RunDirectory): RunRecord {
            for (file in listOf(directory.checkpoint, directory.previousCheckpoint)) {
                try {
                    if (Files.exists(file)) {
                        return RunRecord(
                            directory,
                            Checkpoint.readHead(file),
                            file == directory.checkpoint,
                        )
                    }
                } catch (e: CheckpointException) {
                    // A reader does not depend on it; resume reports what is wrong with it.
                }
            }
            return RunRecord(directory, null, false)
        }
    }
}
