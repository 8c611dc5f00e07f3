package daphnis.core.run

import daphnis.core.collision.CollisionCounters
import kotlinx.serialization.Serializable

/**
 * What a checkpoint holds besides the spheres.
 *
 * @property appended each file that is only appended to, by name in the run directory, up to the checkpoint: what lies
 *   beyond was written later and is cut off on resume
 *
 * @property whole files that are written anew with each checkpoint, by name; with `summary.json` in the last checkpoint
 *   of a run
 *
 * @property losses what was lost of tables, and accepted on a resume, since the start of the run; one line each
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
    val losses: List<String> = emptyList(),
) {
    /** The same with the marks of the run's files. */
    fun with(appended: Map<String, FileMark>, whole: Map<String, FileMark>): CheckpointMeta = CheckpointMeta(
        step, time, collisions, wallCollisions, guardActivations, redoneSteps, causalityReplays, wallSeconds,
        appended, whole, losses,
    )

    /** Sets [counters] to the stored counts. */
    fun countInto(counters: CollisionCounters) {
        counters.collisions = collisions
        counters.wallCollisions = wallCollisions
        counters.guardActivations = guardActivations
        counters.redoneSteps = redoneSteps
        counters.causalityReplays = causalityReplays
    }
}
