package daphnis.core.cluster

import daphnis.core.engine.bricks.Agreed
import daphnis.core.engine.bricks.AttemptKey
import daphnis.core.engine.bricks.BrickCounts
import daphnis.core.engine.bricks.BrickMessage
import daphnis.core.engine.bricks.Halo
import daphnis.core.engine.bricks.IndexRuns
import daphnis.core.engine.bricks.Outcome
import daphnis.core.engine.bricks.PathList
import daphnis.core.population.SphereColumns
import java.nio.ByteBuffer

/** Messages between bricks as bytes. [Agreement][daphnis.core.engine.bricks.Agreement]s answer within a node only. */
internal object BrickWire {
    private const val HALO = 1
    private const val OUTCOME = 2
    private const val AGREED = 3

    /** Writes [message], which is for brick [to]. */
    fun write(to: Int, message: BrickMessage, into: MessageWriter) {
        into.byte(
            when (message) {
                is Halo -> HALO
                is Outcome -> OUTCOME
                is Agreed -> AGREED
                else -> error("$message is not for other nodes")
            },
        )
        into.int(to).int(message.from).int(message.key.epoch).long(message.key.step).int(message.key.attempt)
        when (message) {
            is Halo -> {
                into.int(message.own.size).int(message.near.size)
                SphereBlock.eachColumn(message.spheres) { column ->
                    eachRun(message) { from, until -> into.doubles(column, from, until) }
                }
                eachRun(message) { from, until -> into.ints(message.spheres.id, from, until) }
            }
            is Outcome -> {
                into.int(message.paths.size)
                for (k in 0 until message.paths.size) into.int(message.paths.id(k)).long(message.paths.hash(k))
                into.doubles(message.bound)
            }
            is Agreed -> {
                into.byte((if (message.isRight) 1 else 0) + (if (message.hasFailed) 2 else 0))
                into.doubles(message.bound)
                with(message.counts) { into.long(spheres).long(collisions).long(wallCollisions) }
            }
        }
    }

    private inline fun eachRun(halo: Halo, act: (Int, Int) -> Unit) {
        for (runs in arrayOf(halo.own, halo.near)) for (k in 0 until runs.runs) act(runs.from(k), runs.to(k))
    }

    /** Reads the next message and hands it to [deliver] with the brick that it is for. */
    inline fun read(from: ByteBuffer, deliver: (to: Int, BrickMessage) -> Unit) {
        val kind = from.get().toInt()
        val to = from.int
        val sender = from.int
        val key = AttemptKey(from.int, from.long, from.int)
        deliver(to, body(kind, key, sender, from))
    }

    fun body(kind: Int, key: AttemptKey, sender: Int, from: ByteBuffer): BrickMessage = when (kind) {
        HALO -> {
            val own = from.int
            val near = from.int
            val spheres: SphereColumns = SphereBlock.read(from, own + near)
            Halo(key, sender, spheres, run(0, own), run(own, own + near))
        }
        OUTCOME -> {
            val paths = PathList()
            repeat(from.int) { paths.add(from.int, from.long) }
            Outcome(key, sender, paths, from.doubles(AXES))
        }
        AGREED -> {
            val flags = from.get().toInt()
            val bound = from.doubles(AXES)
            val counts = BrickCounts(from.long, from.long, from.long)
            Agreed(key, sender, flags and 1 != 0, bound, counts, flags and 2 != 0)
        }
        else -> error("a message of kind $kind between bricks")
    }

    private fun run(from: Int, to: Int) = IndexRuns().apply { addAll(from, to) }

    private const val AXES = 3
}
