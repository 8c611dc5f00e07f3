package daphnis.core.run

import daphnis.core.collision.CollisionCounters
import kotlinx.serialization.Serializable

/**
 * What a checkpoint knows beside the spheres.
 *
 * @property appended each file that is only appended to, by name in the run directory, as far as it is the run's: what
 *   lies beyond was written after the checkpoint and is cut off on resume
 * @property whole likewise files that are written anew with each checkpoint; `summary.json` among them in the last of a
 *   run
 * @property losses what was lost of tables, and accepted on a resume, since the start of the run; a line each
 * @property collisionSums of the statistics of collisions, when they are kept; likewise [impactSpeeds]
 */
@Serializable
internal class CheckpointMeta(
    val step: Long,
    val time: Double,
    val collisions: Long,
    val wallCollisions: Long,
    val guardActivations: Long,
    val redoneSteps: Long,
    val causalityReplays: Long,
    val wallSeconds: Double,
    val appended: Map<String, FileMark> = emptyMap(),
    val whole: Map<String, FileMark> = emptyMap(),
    val collisionSums: List<Double> = emptyList(),
    val impactSpeeds: List<Long> = emptyList(),
    val losses: List<String> = emptyList(),
) {
    /** Sets [counters] to what had been counted. */
    fun countInto(counters: CollisionCounters) {
        counters.collisions = collisions
        counters.wallCollisions = wallCollisions
        counters.guardActivations = guardActivations
        counters.redoneSteps = redoneSteps
        counters.causalityReplays = causalityReplays
    }
}

/** [CheckpointMeta] as format 2 has it. */
@Serializable
internal class CheckpointMeta2(
    val step: Long,
    val time: Double,
    val collisions: Long,
    val wallCollisions: Long,
    val guardActivations: Long,
    val redoneSteps: Long,
    val causalityReplays: Long,
    val wallSeconds: Double,
    val fileLengths: Map<String, Long>,
    val collisionSums: List<Double> = emptyList(),
    val impactSpeeds: List<Long> = emptyList(),
) {
    fun current() = CheckpointMeta(
        step, time, collisions, wallCollisions, guardActivations, redoneSteps, causalityReplays, wallSeconds,
        fileLengths.mapValues { FileMark(it.value) }, emptyMap(), collisionSums, impactSpeeds,
    )
}
