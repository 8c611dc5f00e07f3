package daphnis.core.cluster

import java.nio.ByteBuffer

/**
 * Brings what each node of a crew says to all others, and to single ones. What is for all goes around in ⌈log₂ n⌉
 * rounds: a node that knows what the k nodes before it say, itself among them, tells all that to the node k places on,
 * and hears as much from k places back (Bruck et al. 1997, IEEE TPDS 8, 1143). What is for one node goes straight to
 * it, with the first round if that goes there too, and not at all if it is empty. So a node sends some messages more
 * than ⌈log₂ n⌉, however many nodes there are.
 */
internal class Spread(private val mail: Mail) {
    private val rank = mail.rank
    private val size = mail.size

    /** Bytes that this node has sent. */
    var bytesSent = 0L
        private set

    /** Whether something of the present or last time [around] was sent. */
    var hasBegun = false
        private set

    /**
     * What a node has heard, by rank of who said it.
     *
     * @property toAll what was for all; this node's own, too
     * @property toOne what was for this node; null where nothing was
     */
    class Heard(val toAll: Array<ByteBuffer>, val toOne: Array<ByteBuffer?>)

    /**
     * Says [toAll], and to each node its message of [toOne], null for nothing; all nodes call this at the same place.
     * Returns when all was heard.
     *
     * @param toOne by rank, written by [forOne]
     */
    fun around(toAll: ByteBuffer, toOne: Array<ByteBuffer?>): Heard {
        hasBegun = false
        val next = (rank + 1) % size
        for (to in 0 until size) {
            if (to != next) toOne[to]?.let { send(to, it) }
        }
        val ones = arrayOfNulls<ByteBuffer>(size)
        val parts = ArrayList<ByteBuffer>(size)
        parts += part(toAll, toOne)
        while (parts.size < size) {
            val known = parts.size
            val count = minOf(known, size - known)
            val message = MessageWriter().byte(ALL)
            if (known == 1) message.block(toOne[next])
            for (k in 0 until count) message.block(parts[k])
            send((rank + known) % size, message.message())
            val from = back(known)
            val heard = receive(from, ones)
            if (known == 1) heard.block()?.let { ones[from] = it.position(1) }
            repeat(count) { parts += checkNotNull(heard.block()) }
        }
        val all = Array(size) { parts[back(it)] }
        for (from in 0 until size) {
            val isForMe = (0 until all[from].int).count { all[from].int == rank } > 0
            if (isForMe && ones[from] == null) ones[from] = mail.receive(from).position(1)
        }
        return Heard(all, ones)
    }

    /** The rank of the node [places] before this one. */
    private fun back(places: Int) = (rank - places + size) % size

    /** Who gets a message of its own from this node, and what it says to all. */
    private fun part(toAll: ByteBuffer, toOne: Array<ByteBuffer?>): ByteBuffer {
        val to = toOne.indices.filter { toOne[it] != null }
        return MessageWriter().int(to.size).ints(to.toIntArray()).bytes(toAll).message()
    }

    /** The next message of [from] that is for all; one for this node alone may have come before it. */
    private fun receive(from: Int, ones: Array<ByteBuffer?>): ByteBuffer {
        var message = mail.receive(from)
        if (message.get().toInt() == ONE) {
            ones[from] = message
            message = mail.receive(from).position(1)
        }
        return message
    }

    private fun send(to: Int, message: ByteBuffer) {
        val bytes = message.remaining()
        mail.send(to, message)
        hasBegun = true
        bytesSent += bytes
    }

    private fun MessageWriter.block(bytes: ByteBuffer?) {
        int(bytes?.remaining() ?: -1)
        if (bytes != null) bytes(bytes)
    }

    private fun ByteBuffer.block(): ByteBuffer? {
        val length = int
        if (length < 0) return null
        return slice(position(), length).also { position(position() + length) }
    }

    companion object {
        private const val ALL = 0
        private const val ONE = 1

        /** A writer of a message for one node. */
        fun forOne(): MessageWriter = MessageWriter().byte(ONE)

        /** What [writer] of [forOne] has written; null if nothing. */
        fun forOne(writer: MessageWriter): ByteBuffer? = if (writer.size > 1) writer.message() else null
    }
}
