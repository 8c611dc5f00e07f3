package daphnis.cluster.link

import java.nio.ByteBuffer

/**
 * The sending half of a link: cuts messages into chunks, has at most a window of them on the way, and sends all anew
 * from the first that is not acknowledged when nothing was acknowledged for too long. It keeps references to the
 * messages and copies nothing. Not safe for threads: see [Link].
 *
 * ```
 *   number    0 ........ base ............ next ............ end
 *             acknowledged | on the way      | not yet sent
 * ```
 */
internal class Outbox(
    private val crew: Long,
    private val from: Int,
    private val to: Int,
    private val limits: LinkLimits,
    private val wire: (LinkMessage) -> Unit,
) {
    /** A message whose chunks have the numbers from [first] on. */
    private inner class Outgoing(val body: ByteBuffer, val first: Long) {
        val length = body.remaining()
        val end = first + maxOf(1, (length.toLong() + limits.chunk - 1) / limits.chunk)

        fun offset(number: Long) = ((number - first) * limits.chunk).toInt()

        fun size(number: Long) = minOf(limits.chunk, length - offset(number))
    }

    /** Messages with chunks that are not acknowledged, the oldest first. */
    private val messages = ArrayDeque<Outgoing>()

    /** Index in [messages] of the one that has the chunk [next]. */
    private var cursor = 0
    private var base = 0L
    private var next = 0L
    private var end = 0L

    /** One more than the greatest number ever sent. */
    private var sent = 0L

    /** One more than the greatest number that the receiver lets in. */
    private var limit = limits.first

    /** Bytes from [base] to [next]. */
    private var flying = 0L
    private var patience = limits.patience
    private var deadline = NEVER

    /** Chunks that wait for their first sending or for their receipt. */
    val pending: Long get() = end - base

    /** Bytes handed to the wire and not acknowledged. */
    val bytesOnTheWay: Long get() = flying

    /** Takes [body] on and sends what the window admits. */
    fun send(body: ByteBuffer, now: Long) {
        require(body.remaining() <= limits.message) {
            "a message of ${body.remaining()} bytes; at most ${limits.message} are sent"
        }
        val outgoing = Outgoing(body.slice(), end)
        messages.addLast(outgoing)
        end = outgoing.end
        pump(now)
    }

    /** The receiver has all chunks before [next] and admits those before [limit]. */
    fun acknowledge(next: Long, limit: Long, now: Long) {
        // A number that was never sent is none of this link's.
        if (next > sent || next < base) return
        this.limit = maxOf(this.limit, limit)
        if (next > base) {
            forget(next)
            patience = limits.patience
            deadline = NEVER
        }
        pump(now)
    }

    /** Sends anew what has waited too long at the time [now]. */
    fun tick(now: Long) {
        if (deadline == NEVER || now - deadline < 0) return
        patience = minOf(2 * patience, limits.longest)
        deadline = now + patience
        if (next == base) {
            wire(Probe(crew, from, to))
            return
        }
        next = base
        cursor = 0
        flying = 0
        pump(now)
    }

    private fun forget(until: Long) {
        while (base < until) {
            val oldest = messages.first()
            if (base < next) flying -= oldest.size(base)
            base++
            if (base == oldest.end) {
                messages.removeFirst()
                cursor--
            }
        }
        if (next < base) {
            next = base
            flying = 0
        }
        cursor = maxOf(cursor, 0)
    }

    private fun pump(now: Long) {
        val most = minOf(end, limit, base + limits.chunks)
        while (next < most) {
            val message = messages[cursor]
            val size = message.size(next)
            if (flying > 0 && flying + size > limits.window) break
            wire(chunk(message, size))
            flying += size
            next++
            if (next == message.end) cursor++
        }
        sent = maxOf(sent, next)
        if (base == end) {
            deadline = NEVER
        } else if (deadline == NEVER) {
            deadline = now + patience
        }
    }

    private fun chunk(message: Outgoing, size: Int): Chunk {
        val offset = message.offset(next)
        val bytes = message.body.slice(offset, size)
        val check = Chunk.checkOf(crew, from, to, next, message.length, offset, bytes)
        return Chunk(crew, from, to, next, message.length, offset, bytes, check)
    }

    private companion object {
        const val NEVER = Long.MIN_VALUE
    }
}
