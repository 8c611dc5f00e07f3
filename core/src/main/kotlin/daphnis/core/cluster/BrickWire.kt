package daphnis.core.cluster

import daphnis.core.cluster.bricks.Agreed
import daphnis.core.cluster.bricks.AttemptKey
import daphnis.core.cluster.bricks.BrickCounts
import daphnis.core.cluster.bricks.BrickMessage
import daphnis.core.cluster.bricks.Halo
import daphnis.core.cluster.bricks.IndexRuns
import daphnis.core.cluster.bricks.Outcome
import daphnis.core.cluster.bricks.PathList
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import java.nio.ByteBuffer

/**
 * Messages between bricks as bytes: a head, which says the same to all bricks, and what is for one of them alone.
 * [Agreement][daphnis.core.cluster.bricks.Agreement]s answer within a node only.
 */
internal object BrickWire {
    private const val HALO = 1
    private const val OUTCOME = 2
    private const val AGREED = 3
    private const val AXES = 3
    private val noSpheres = PopulationColumns.joined(emptyList())

    /** Whether [message] has nothing but its head. */
    fun isEmpty(message: BrickMessage): Boolean = when (message) {
        is Halo -> message.own.size + message.near.size == 0
        is Outcome -> message.paths.size == 0
        else -> true
    }

    /** Whether [one] and [other] have the same head. */
    fun haveSameHead(one: BrickMessage, other: BrickMessage): Boolean =
        one.javaClass == other.javaClass && one.from == other.from && one.key == other.key

    /** Writes the head of [message]. */
    fun writeHead(message: BrickMessage, into: MessageWriter) {
        into.byte(
            when (message) {
                is Halo -> HALO
                is Outcome -> OUTCOME
                is Agreed -> AGREED
                else -> error("$message is not for other nodes")
            },
        )
        into.int(message.from).int(message.key.epoch).long(message.key.step).int(message.key.attempt)
        when (message) {
            is Outcome -> into.doubles(message.bound)
            is Agreed -> {
                into.byte((if (message.isRight) 1 else 0) + (if (message.hasFailed) 2 else 0))
                into.doubles(message.bound)
                with(message.counts) { into.long(spheres).long(collisions).long(wallCollisions) }
            }
            else -> Unit
        }
    }

    /** Reads a head as a message that is otherwise empty. */
    fun readHead(from: ByteBuffer): BrickMessage {
        val kind = from.get().toInt()
        val sender = from.int
        val key = AttemptKey(from.int, from.long, from.int)
        return when (kind) {
            HALO -> Halo(key, sender, noSpheres, IndexRuns(), IndexRuns())
            OUTCOME -> Outcome(key, sender, PathList(), from.doubles(AXES))
            AGREED -> {
                val flags = from.get().toInt()
                val bound = from.doubles(AXES)
                val counts = BrickCounts(from.long, from.long, from.long)
                Agreed(key, sender, flags and 1 != 0, bound, counts, flags and 2 != 0)
            }
            else -> error("a message of kind $kind between bricks")
        }
    }

    /** Writes [message], which is for brick [to]. */
    fun write(to: Int, message: BrickMessage, into: MessageWriter) {
        into.int(to)
        writeHead(message, into)
        when (message) {
            is Halo -> {
                into.int(message.own.size).int(message.near.size)
                SphereBlock.write(into, message.spheres) { act -> eachRun(message, act) }
            }
            is Outcome -> {
                into.int(message.paths.size)
                for (k in 0 until message.paths.size) into.int(message.paths.id(k)).long(message.paths.hash(k))
            }
            else -> Unit
        }
    }

    private inline fun eachRun(halo: Halo, act: (Int, Int) -> Unit) {
        for (runs in arrayOf(halo.own, halo.near)) for (k in 0 until runs.runs) act(runs.from(k), runs.to(k))
    }

    /** Reads the next message and hands it to [deliver] with the brick that it is for. */
    inline fun read(from: ByteBuffer, deliver: (to: Int, BrickMessage) -> Unit) {
        val to = from.int
        deliver(to, withBody(readHead(from), from))
    }

    fun withBody(head: BrickMessage, from: ByteBuffer): BrickMessage = when (head) {
        is Halo -> {
            val own = from.int
            val near = from.int
            val spheres: SphereColumns = SphereBlock.read(from, own + near)
            Halo(head.key, head.from, spheres, run(0, own), run(own, own + near))
        }
        is Outcome -> head.also { repeat(from.int) { _ -> it.paths.add(from.int, from.long) } }
        else -> head
    }

    private fun run(from: Int, to: Int) = IndexRuns().apply { addAll(from, to) }
}
