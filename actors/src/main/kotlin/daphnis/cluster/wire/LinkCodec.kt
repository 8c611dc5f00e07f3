package daphnis.cluster.wire

import daphnis.cluster.link.Chunk
import daphnis.cluster.link.LinkMessage
import daphnis.cluster.link.Probe
import daphnis.cluster.link.Receipt
import java.nio.ByteBuffer

/**
 * What links say as bytes, big-endian. A chunk's piece is copied once, from the caller's buffer into the frame, and
 * once out of the frame.
 */
internal object LinkCodec {
    fun write(message: LinkMessage, to: ByteBuffer) {
        to.put(kindOf(message)).putLong(message.crew).putInt(message.from).putInt(message.to)
        when (message) {
            is Chunk -> {
                to.putLong(message.number).putInt(message.length).putInt(message.offset).putInt(message.check)
                to.putInt(message.bytes.remaining()).put(message.bytes.duplicate())
            }
            is Receipt -> to.putLong(message.next).putLong(message.limit)
            is Probe -> Unit
        }
    }

    fun read(from: ByteBuffer): LinkMessage {
        val kind = from.get()
        val crew = from.getLong()
        val sender = from.getInt()
        val receiver = from.getInt()
        return when (kind) {
            'D'.code.toByte() -> {
                val number = from.getLong()
                val length = from.getInt()
                val offset = from.getInt()
                val check = from.getInt()
                Chunk(crew, sender, receiver, number, length, offset, piece(from), check)
            }
            'A'.code.toByte() -> Receipt(crew, sender, receiver, from.getLong(), from.getLong())
            'Q'.code.toByte() -> Probe(crew, sender, receiver)
            else -> throw IllegalArgumentException("a frame of the kind $kind")
        }
    }

    /** Bytes that [message] takes. */
    fun room(message: LinkMessage): Int = HEAD + if (message is Chunk) message.bytes.remaining() else 0

    private fun piece(from: ByteBuffer): ByteBuffer {
        val size = from.getInt()
        require(size in 0..from.remaining()) { "a piece of $size bytes in ${from.remaining()}" }
        return ByteBuffer.wrap(ByteArray(size).also(from::get))
    }

    private fun kindOf(message: LinkMessage): Byte = when (message) {
        is Chunk -> 'D'
        is Receipt -> 'A'
        is Probe -> 'Q'
    }.code.toByte()

    /** More than the fields before the piece take. */
    private const val HEAD = 64
}
