package daphnis.core.run

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.Counter
import daphnis.core.force.Force
import daphnis.core.population.Carried
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
 * @property forces the state of each force that has one, in their order
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
    @EncodeDefault(EncodeDefault.Mode.NEVER) val forces: List<List<Double>> = emptyList(),
) {
    init {
        val lacks = Counter.entries.find { it.isOfTrajectory && !it.isNew && it.key !in counted }
        require(lacks == null) { "it does not say ${lacks?.key}" }
        val wrong = pistons.entries.find { (_, state) -> state.size != 2 || !state.all { it.isFinite() } }
        require(wrong == null) { "the piston at face ${wrong?.key} has the state ${wrong?.value}" }
        val odd = forces.find { state -> !state.all { it.isFinite() } }
        require(odd == null) { "a force has the state $odd" }
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
        forces,
    )

    /** Puts the pistons of [boundary], and those of [all] forces that have a state, where they were. */
    fun put(boundary: BoundaryConditions, all: List<Force>) {
        for ((face, piston) in boundary.walls.pistons) {
            piston.carried = requireNotNull(pistons[face]) { "it does not say where the piston at face $face is" }
                .toDoubleArray()
        }
        reducedPressure?.let { boundary.growth?.resume(it) }
        val carriers = carriers(all)
        require(carriers.map { it.carried.size } == forces.map { it.size }) {
            "it has ${forces.size} states of forces, and ${carriers.size} forces have one"
        }
        for ((carrier, state) in carriers.zip(forces)) carrier.carried = state.toDoubleArray()
    }

    /** Sets [counters] to the stored counts. */
    fun countInto(counters: CollisionCounters) {
        for (counter in Counter.entries) counters[counter] = counted[counter.key] ?: 0
    }

    companion object {
        /** In the file, where counts stand among the other numbers. */
        val FILED = CountersAtTop(serializer())

        private fun carriers(all: List<Force>) = all.filterIsInstance<Carried>().filter { it.carried.isNotEmpty() }

        /** What [all] forces carry, as `forces` has it. */
        fun carried(all: List<Force>): List<List<Double>> = carriers(all).map { it.carried.asList() }

        /** The counts of [counters], as `counted` has them. */
        fun counted(counters: CollisionCounters): Map<String, Long> =
            Counter.entries.associate { it.key to counters[it] }
    }
}
