package daphnis.core.run

import daphnis.core.format.Snapshot
import daphnis.core.input.InputException
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.Surroundings
import java.nio.file.Files
import java.nio.file.Path

/**
 * The states in the checkpoints of a run. Without the scenario of a [Program] it is not known where its box repeats,
 * so only snapshots tell its states.
 */
internal class CheckpointState(private val directory: RunDirectory) {
    /** Step of the last checkpoint; null when there is none. */
    fun lastStep(): Long? = files().firstNotNullOfOrNull { head(it) }?.meta?.step

    /** What the checkpoint of the state after [step] knows besides the spheres, if one of the checkpoints is of it. */
    fun meta(step: Long): CheckpointMeta? =
        files().firstNotNullOfOrNull { file -> head(file)?.meta?.takeIf { it.step == step } }

    /** The state after [step], if one of the checkpoints is of it. */
    fun read(step: Long): Snapshot? {
        for (file in files()) {
            if (head(file)?.meta?.step != step) continue
            val checkpoint = reading(file) { Checkpoint.read(it) } ?: continue
            // It was replaced between the two calls.
            if (checkpoint.meta.step != step) continue
            val boundary = Surroundings.of(scenario(checkpoint, file), "$file").boundary
            return Snapshot.of(checkpoint.population, boundary, step, checkpoint.meta.time)
        }
        return null
    }

    private fun files(): List<Path> {
        if (Files.exists(directory.program)) return emptyList()
        return listOf(directory.checkpoint, directory.previousCheckpoint).filter { Files.exists(it) }
    }

    private fun head(file: Path) = reading(file) { Checkpoint.readHead(it) }

    /** Read again when it fails, for the run may have replaced the file meanwhile; null when it is gone. */
    private fun <T> reading(file: Path, read: (Path) -> T): T? {
        var problem = ""
        repeat(ATTEMPTS) {
            try {
                return read(file)
            } catch (e: CheckpointException) {
                problem = e.message.orEmpty()
            }
            if (!Files.exists(file)) return null
        }
        throw InputException("", null, problem)
    }

    /** The scenario with which the run was made; format 2 does not know it. */
    private fun scenario(checkpoint: Checkpoint, file: Path): Scenario =
        checkpoint.scenario?.let { ScenarioJson.parse(it, "$file") } ?: ScenarioJson.read(directory.scenario)

    private companion object {
        const val ATTEMPTS = 3
    }
}
