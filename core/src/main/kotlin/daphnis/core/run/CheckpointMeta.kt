package daphnis.core.run

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.Counter
import daphnis.core.wall.pistons
import kotlinx.serialization.EncodeDefault
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.Serializable

/**
 * What a checkpoint holds besides the spheres.
 *
 * @property counted what was counted since the start of the run, by the key of each [Counter]
 *
 * @property appended each file that is only appended to, by name in the run directory, up to the checkpoint: what lies
 *   beyond was written later and is cut off on resume
 *
 * @property whole files that are written anew with each checkpoint, by name; with `summary.json` in the last checkpoint
 *   of a run
 *
 * @property reducedPressure where spheres grow, that of the last step
 *
 * @property pistons position and speed of each wall that is a piston, by the number of its face
 *
 * @property snapshots checksum of each state that was written as a snapshot, by step
 *
 * @property losses what was lost of tables, and accepted on a resume, since the start of the run; one line each
 */
@OptIn(ExperimentalSerializationApi::class)
@Serializable
internal class CheckpointMeta(
    val step: Long,
    val time: Double,
    val counted: Map<String, Long>,
    val wallSeconds: Double,
    val appended: Map<String, FileMark> = emptyMap(),
    val whole: Map<String, FileMark> = emptyMap(),
    val losses: List<String> = emptyList(),
    @EncodeDefault(EncodeDefault.Mode.NEVER) val reducedPressure: Double? = null,
    @EncodeDefault(EncodeDefault.Mode.NEVER) val pistons: Map<Int, List<Double>> = emptyMap(),
    @EncodeDefault(EncodeDefault.Mode.NEVER) val snapshots: Map<Long, Long> = emptyMap(),
) {
    init {
        val lacks = Counter.entries.find { it.isOfTrajectory && !it.isNew && it.key !in counted }
        require(lacks == null) { "it does not say ${lacks?.key}" }
        val wrong = pistons.entries.find { (_, state) -> state.size != 2 || !state.all { it.isFinite() } }
        require(wrong == null) { "the piston at face ${wrong?.key} has the state ${wrong?.value}" }
    }

    /** The same with the marks of the run's files. */
    fun with(
        appended: Map<String, FileMark>,
        whole: Map<String, FileMark>,
        snapshots: Map<Long, Long>,
    ): CheckpointMeta = CheckpointMeta(
        step,
        time,
        counted,
        wallSeconds,
        appended,
        whole,
        losses,
        reducedPressure,
        pistons,
        snapshots,
    )

    /** Puts the pistons of [boundary] where they were. */
    fun putPistons(boundary: BoundaryConditions) {
        for ((face, piston) in boundary.walls.pistons) {
            val (position, speed) =
                requireNotNull(pistons[face]) { "it does not say where the piston at face $face is" }
            piston.put(position, speed)
        }
    }

    /** Sets [counters] to the stored counts. */
    fun countInto(counters: CollisionCounters) {
        for (counter in Counter.entries) counters[counter] = counted[counter.key] ?: 0
    }

    companion object {
        /** In the file, where counts stand among the other numbers. */
        val FILED = CountersAtTop(serializer())

        /** The counts of [counters], as `counted` has them. */
        fun counted(counters: CollisionCounters): Map<String, Long> =
            Counter.entries.associate { it.key to counters[it] }
    }
}
