package daphnis.core.run

import daphnis.core.OutputState
import kotlinx.serialization.Serializable

/**
 * [CheckpointMeta] as formats 2 and 3 have it: with what the output that writes `transport.csv` has saved. Format 2
 * knows [fileLengths] of the files to which a run appends, and nothing else of other files.
 */
@Serializable
internal class OlderMeta(
    val step: Long,
    val time: Double,
    val counted: Map<String, Long>,
    val wallSeconds: Double,
    val appended: Map<String, FileMark> = emptyMap(),
    val whole: Map<String, FileMark> = emptyMap(),
    val collisionSums: List<Double> = emptyList(),
    val impactSpeeds: List<Long> = emptyList(),
    val losses: List<String> = emptyList(),
    val fileLengths: Map<String, Long> = emptyMap(),
) {
    fun current() = CheckpointMeta(
        step,
        time,
        counted,
        wallSeconds,
        appended + fileLengths.mapValues { FileMark(it.value) },
        whole,
        losses,
    )

    /** What the output has saved, under its name; empty when it was not there. */
    fun saved(): Map<String, OutputState> {
        if (collisionSums.isEmpty()) return emptyMap()
        val state = OutputState(TransportOutput.name)
        state.put(CollisionStatistics.SUMS_SAVED, collisionSums.toDoubleArray())
        state.put(CollisionStatistics.SPEEDS_SAVED, impactSpeeds.toLongArray())
        return mapOf(TransportOutput.name to state)
    }

    companion object {
        /** In the file, where counts stand among the other numbers. */
        val FILED = CountersAtTop(serializer())
    }
}
