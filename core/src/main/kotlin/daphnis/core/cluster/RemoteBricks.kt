package daphnis.core.cluster

import daphnis.core.cluster.bricks.Agreed
import daphnis.core.cluster.bricks.BrickMessage
import daphnis.core.cluster.bricks.BrickPlaces
import daphnis.core.cluster.bricks.Mailboxes

/**
 * The bricks of the nodes of a crew: each has as many, one after the other, as it has threads. A brick sends to all
 * others, but says something only to those near it. What is empty but for its head goes to all at once, and is taken as
 * a message to each brick that was sent none.
 *
 * @param threads by rank
 */
internal class RemoteBricks(private val turns: Turns, private val threads: IntArray) : BrickPlaces {
    private val before = IntArray(threads.size + 1).also { for (k in threads.indices) it[k + 1] = it[k] + threads[k] }
    private val mine = before[turns.rank] until before[turns.rank + 1]

    /** Messages of this node's bricks without what is for single ones; one per brick and kind. */
    private val heads = ArrayList<BrickMessage>()

    /** Who has sent what to which of the bricks here. */
    private val sent = HashSet<List<Any>>()

    override fun from(bricks: Int): Int = mine.first

    override fun to(bricks: Int): Int = mine.last + 1

    override fun carry(boxes: Mailboxes) {
        heads.clear()
        sent.clear()
        turns.exchange(
            { rank, message ->
                for (brick in before[rank] until before[rank + 1]) {
                    boxes.take(brick) {
                        if (heads.none { head -> BrickWire.haveSameHead(head, it) }) heads += it
                        if (!BrickWire.isEmpty(it)) BrickWire.write(brick, it, message)
                    }
                }
            },
            {
                for (head in heads) BrickWire.writeHead(head, this)
                boxes.look { BrickWire.writeHead(it, this) }
            },
            { _, message ->
                while (message.hasRemaining()) {
                    BrickWire.read(message) { to, what ->
                        sent += key(to, what)
                        boxes.deliver(to, what)
                    }
                }
            },
            { _, message ->
                while (message.hasRemaining()) {
                    val what = BrickWire.readHead(message)
                    if (what is Agreed) {
                        boxes.deliver(BrickMessage.AGREEMENT, what)
                    } else {
                        for (to in mine) if (key(to, what) !in sent) boxes.deliver(to, what)
                    }
                }
            },
        )
    }

    private fun key(to: Int, message: BrickMessage): List<Any> = listOf(to, message.from, message.javaClass)
}
