package daphnis.core.cluster

import daphnis.core.engine.bricks.BrickMessage
import daphnis.core.engine.bricks.BrickPlaces
import daphnis.core.engine.bricks.Mailboxes

/**
 * The bricks of the nodes of a crew: each has as many, one after the other, as it has threads.
 *
 * @param threads by rank
 */
internal class RemoteBricks(private val turns: Turns, private val threads: IntArray) : BrickPlaces {
    private val before = IntArray(threads.size + 1).also { for (k in threads.indices) it[k + 1] = it[k] + threads[k] }

    /** Bytes that this node has sent to others for bricks. */
    var bytesSent = 0L
        private set

    override fun from(bricks: Int): Int = before[turns.rank]

    override fun to(bricks: Int): Int = before[turns.rank + 1]

    override fun carry(boxes: Mailboxes) {
        turns.exchange(
            { rank, message ->
                for (brick in before[rank] until before[rank + 1]) {
                    boxes.take(brick) {
                        BrickWire.write(brick, it, message)
                    }
                }
                boxes.look { BrickWire.write(BrickMessage.AGREEMENT, it, message) }
                bytesSent += message.size
            },
            { _, message ->
                while (message.hasRemaining()) BrickWire.read(message) { to, what -> boxes.deliver(to, what) }
            },
        )
    }
}
