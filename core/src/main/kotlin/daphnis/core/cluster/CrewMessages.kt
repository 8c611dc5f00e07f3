package daphnis.core.cluster

import daphnis.core.CommonNumber
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.Counter
import daphnis.core.engine.StepTally
import daphnis.core.source.SourceSums
import java.nio.ByteBuffer

/** What the leader of a crew asks of each node. */
internal enum class Command {
    STEP,
    GATHER,

    /** First moments, potential energies and sums over spins of the node's spheres. */
    FIRST_SUMS,

    /** Second moments around the means that follow, and sums by material, whose number follows these. */
    CENTRAL_SUMS,

    /** A [CommonNumber] whose place follows, of the force whose place follows that. */
    NUMBER,
}

/** How a node answers [Command.STEP]. */
internal enum class Answer { DONE, FAILED, FAILED_ELSEWHERE }

/**
 * The first message of the leader to a node, followed by the spheres that it is to begin with.
 *
 * @property scenario as the run has resolved it, in JSON
 * @property step number of steps since the start of the run
 * @property time at the end of that step
 * @property carried what it carries besides the spheres
 * @property records whether collisions are sent
 * @property tally the kinds of [StepTally] that are to be sent in their place; negative for none
 * @property threads by rank
 * @property ids all ids of the run, where they are not dense
 * @property idCount number of places for ids
 */
internal class Begin(
    val scenario: String,
    val step: Long,
    val time: Double,
    val carried: DoubleArray,
    val records: Boolean,
    val tally: Int,
    val threads: IntArray,
    val ids: IntArray?,
    val idCount: Int,
) {
    fun message(): ByteBuffer = MessageWriter().text(scenario).long(step).double(time)
        .int(carried.size).doubles(carried).byte(if (records) 1 else 0).int(tally)
        .int(threads.size).ints(threads).int(idCount).int(ids?.size ?: -1).ints(ids ?: IntArray(0)).message()

    companion object {
        fun read(from: ByteBuffer): Begin {
            val scenario = from.text()
            val step = from.long
            val time = from.double
            val carried = from.doubles(from.int)
            val records = from.get().toInt() == 1
            val tally = from.int
            val threads = from.ints(from.int)
            val idCount = from.int
            val sparse = from.int
            val ids = if (sparse < 0) null else from.ints(sparse)
            return Begin(scenario, step, time, carried, records, tally, threads, ids, idCount)
        }
    }
}

/**
 * What a node has done in a step.
 *
 * @property time at the end of the step
 * @property total number of spheres of all nodes
 * @property held number of spheres that the node holds
 * @property seconds that the step took
 * @property carried what the simulation carries besides the spheres
 * @property exchanged what came and left; null without sources
 */
internal class StepDone(
    val time: Double,
    val duration: Double,
    val total: Int,
    val held: Int,
    val seconds: Double,
    val carried: DoubleArray,
    val cost: NodeCost,
    val counted: CollisionCounters,
    val record: CollisionRecord?,
    val tally: StepTally?,
    val exchanged: SourceSums?,
)

/**
 * What the bricks of a node have cost since the node began.
 *
 * @property redone attempts that bricks of the crew computed again
 * @property haloSpheres in the last step
 * @property bytesSent to other nodes
 */
internal class NodeCost(val redone: Long, val haloSpheres: Int, val bytesSent: Long)

internal fun MessageWriter.stepDone(done: StepDone): MessageWriter = apply {
    double(done.time).double(done.duration).int(done.total).int(done.held).double(done.seconds)
    int(done.carried.size).doubles(done.carried)
    long(done.cost.redone).int(done.cost.haloSpheres).long(done.cost.bytesSent)
    for (counter in Counter.entries) long(done.counted[counter])
    record(done.record)
    tally(done.tally)
    int(done.exchanged?.sources ?: -1)
    done.exchanged?.let { put(it.mostBytes, it::write) }
}

internal fun ByteBuffer.stepDone(): StepDone = StepDone(
    double,
    double,
    int,
    int,
    double,
    doubles(int),
    NodeCost(long, int, long),
    CollisionCounters().also { for (counter in Counter.entries) it[counter] = long },
    record(),
    tally(),
    exchanged(),
)

private fun MessageWriter.record(record: CollisionRecord?) {
    if (record == null) {
        int(-1)
        return
    }
    int(record.size)
    doubles(record.time, 0, record.size)
    ints(record.rank, 0, record.size)
    ints(record.lower, 0, record.size)
    ints(record.higher, 0, record.size)
    doubles(record.data, 0, record.size * CollisionRecord.WIDTH)
}

private fun ByteBuffer.record(): CollisionRecord? {
    val size = int
    if (size < 0) return null
    return CollisionRecord(doubles(size), ints(size), ints(size), ints(size), doubles(size * CollisionRecord.WIDTH))
}

private fun MessageWriter.tally(tally: StepTally?) {
    int(tally?.kinds ?: -1)
    for (sums in tally?.all.orEmpty()) put(sums.mostBytes, sums::write)
}

private fun ByteBuffer.exchanged(): SourceSums? {
    val sources = int
    return if (sources < 0) null else SourceSums(sources).also { it.read(this) }
}

private fun ByteBuffer.tally(): StepTally? {
    val kinds = int
    return if (kinds < 0) null else StepTally.of(kinds).also { for (sums in it.all) sums.read(this) }
}
