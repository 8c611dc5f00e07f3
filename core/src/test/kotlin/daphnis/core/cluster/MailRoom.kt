package daphnis.core.cluster

import java.nio.ByteBuffer
import java.util.concurrent.LinkedBlockingQueue

/** The mail of one crew in one process. */
internal class MailRoom(private val nodes: Int, private val onSend: (Int, Int, ByteBuffer) -> Unit = { _, _, _ -> }) {
    private val boxes = Array(nodes + 1) { Array(nodes + 1) { LinkedBlockingQueue<ByteBuffer>() } }

    @Volatile
    private var end: String? = null

    fun end(why: String) {
        if (end == null) end = why
        for (row in boxes) for (box in row) box.add(LAST)
    }

    /** What was sent and not received. */
    fun unread(): Int = boxes.sumOf { row -> row.sumOf { it.size } }

    fun mail(mine: Int): Mail = object : Mail {
        override val rank = mine
        override val size = nodes
        override val isClosed: Boolean get() = end != null

        override fun send(to: Int, body: ByteBuffer) {
            end?.let { throw MailClosedException(it) }
            onSend(mine, to, body)
            // Bytes of its own, as after a way through a network.
            val copy = ByteBuffer.allocate(body.remaining()).put(body.duplicate()).flip()
            boxes[to + 1][mine + 1].add(copy)
        }

        override fun receive(from: Int): ByteBuffer {
            val box = boxes[mine + 1][from + 1]
            val message = box.take()
            end?.let {
                // For whoever asks again.
                box.add(LAST)
                throw MailClosedException(it)
            }
            return message
        }

        override fun close() = end("the leader has ended the crew")
    }

    private companion object {
        val LAST: ByteBuffer = ByteBuffer.allocate(0)
    }
}
