package daphnis.cluster.link

import daphnis.core.cluster.MailClosedException
import java.nio.ByteBuffer
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Both halves of the link between two members of a crew, as one of them has it, for all threads.
 *
 * | thread | calls |
 * |---|---|
 * | of the member's work | [send], [receive] |
 * | of the network | [accept], [tick] |
 * | any | [end] |
 *
 * One lock guards both halves. It is held while chunks are handed to the wire, since their order is the link's; the
 * wire is a queue that neither blocks nor calls back.
 */
internal class Link(
    crew: Long,
    private val self: Int,
    private val other: Int,
    limits: LinkLimits,
    wire: (LinkMessage) -> Unit,
) {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val outbox = Outbox(crew, self, other, limits, wire)
    private val inbox = Inbox(crew, other, self, limits, wire)
    private var ending: String? = null

    fun send(body: ByteBuffer): Unit = lock.withLock {
        ending?.let { throw MailClosedException(it) }
        outbox.send(body, System.nanoTime())
    }

    /** Waits for a message. What had come before the end is given out after it too. */
    fun receive(): ByteBuffer = lock.withLock {
        while (!inbox.hasMessage) {
            ending?.let { throw MailClosedException(it) }
            changed.await()
        }
        inbox.poll()!!
    }

    fun accept(message: LinkMessage): Unit = lock.withLock {
        if (ending != null) return
        when (message) {
            is Chunk -> if (inbox.take(message)) changed.signal()
            is Receipt -> outbox.acknowledge(message.next, message.limit, System.nanoTime())
            is Probe -> inbox.acknowledge()
        }
    }

    fun tick(): Unit = lock.withLock {
        if (ending != null) return
        outbox.tick(System.nanoTime())
        inbox.tick()
    }

    /** Ends the link for [reason]; the first counts. */
    fun end(reason: String): Unit = lock.withLock {
        if (ending == null) ending = reason
        changed.signalAll()
    }

    /** Bytes handed to the wire and not acknowledged, and bytes of whole messages that wait here; for tests. */
    fun load(): Pair<Long, Long> = lock.withLock { outbox.bytesOnTheWay to inbox.bytesWaiting }
}
