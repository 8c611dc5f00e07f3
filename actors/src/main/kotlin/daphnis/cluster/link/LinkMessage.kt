package daphnis.cluster.link

import java.nio.ByteBuffer
import java.util.zip.CRC32C

/** What the two ends of a link say to each other: member [from] to member [to] of the crew with the key [crew]. */
internal sealed interface LinkMessage {
    val crew: Long
    val from: Int
    val to: Int
}

/**
 * A piece of a message.
 *
 * @property number of the chunk in its link, from 0
 * @property length of the whole message, bytes
 * @property offset of this piece in it, bytes
 * @property bytes the remaining ones are the piece; a view of the caller's buffer on the side that sends
 * @property check [checkOf] the piece as it was sent
 */
internal class Chunk(
    override val crew: Long,
    override val from: Int,
    override val to: Int,
    val number: Long,
    val length: Int,
    val offset: Int,
    val bytes: ByteBuffer,
    val check: Int,
) : LinkMessage {
    /** Whether nothing has changed on the way. */
    val isWhole: Boolean get() = check == checkOf(crew, from, to, number, length, offset, bytes)

    companion object {
        /** CRC-32C of what a chunk says and where it belongs. */
        fun checkOf(crew: Long, from: Int, to: Int, number: Long, length: Int, offset: Int, bytes: ByteBuffer): Int {
            val place = ByteBuffer.allocate(PLACE).putLong(crew).putInt(from).putInt(to)
            place.putLong(number).putInt(length).putInt(offset).flip()
            val sum = CRC32C()
            sum.update(place)
            sum.update(bytes.duplicate())
            return sum.value.toInt()
        }

        private const val PLACE = 32
    }
}

/**
 * All chunks before number [next] have come, and those before number [limit] may be sent.
 */
internal class Receipt(
    override val crew: Long,
    override val from: Int,
    override val to: Int,
    val next: Long,
    val limit: Long,
) : LinkMessage

/** Asks for a receipt: the last one, which would allow more, may be lost. */
internal class Probe(override val crew: Long, override val from: Int, override val to: Int) : LinkMessage
