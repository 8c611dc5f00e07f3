package daphnis.core.cluster

import java.nio.ByteBuffer

/**
 * What the nodes of a crew do together. In a turn each sends a message to each other, and takes one from each. All make
 * the same turns in the same order. A node that has failed says so in place of its next message ([fail]); then the turn
 * throws [NodeFailedException] at all others. After that all are at the same place again.
 */
internal class Turns(private val mail: Mail) {
    val rank: Int get() = mail.rank
    val size: Int get() = mail.size

    /**
     * One turn. [write] adds what the node of a rank is to know, [read] takes what it says, in the order of ranks.
     */
    inline fun exchange(write: (rank: Int, MessageWriter) -> Unit, read: (rank: Int, ByteBuffer) -> Unit) {
        // All are written before the first is sent, so that a failure says so to all.
        val messages = others().map { to -> MessageWriter().byte(FINE).also { write(to, it) }.message() }
        for ((k, to) in others().withIndex()) mail.send(to, messages[k])
        takeAll(read)
    }

    /** The same with one [message] for all. */
    inline fun tell(message: MessageWriter.() -> Unit, read: (rank: Int, ByteBuffer) -> Unit) {
        if (size == 1) return
        val bytes = MessageWriter().byte(FINE).apply(message).message()
        for (to in others()) mail.send(to, bytes.duplicate())
        takeAll(read)
    }

    /** The [numbers] of all nodes, by rank; all give as many. */
    fun gather(numbers: DoubleArray): Array<DoubleArray> {
        val all = Array(size) { numbers }
        tell({ doubles(numbers) }) { from, message -> all[from] = message.doubles(numbers.size) }
        return all
    }

    /** Replaces each of [numbers] by the greatest of all nodes. */
    fun max(numbers: DoubleArray) {
        for (other in gather(numbers.copyOf())) {
            for (k in numbers.indices) numbers[k] = maxOf(numbers[k], other[k])
        }
    }

    /** Takes part in a turn by saying that this node has failed because of [cause]. Does not throw what others say. */
    fun fail(cause: Throwable) {
        val bytes = MessageWriter().byte(FAILED).text(cause.toString()).message()
        for (to in others()) mail.send(to, bytes.duplicate())
        for (from in others()) mail.receive(from)
    }

    fun others(): List<Int> = (0 until size).filter { it != rank }

    inline fun takeAll(read: (rank: Int, ByteBuffer) -> Unit) {
        // All are received, whatever is in them, so that the next turn begins with its own messages.
        val messages = others().map { it to mail.receive(it) }
        for ((from, message) in messages) {
            if (message.get().toInt() != FINE) throw NodeFailedException(from, message.text())
        }
        for ((from, message) in messages) read(from, message)
    }

    companion object {
        const val FINE = 0
        const val FAILED = 1
    }
}

/** Another node has failed in the turn: that of [rank]. */
internal class NodeFailedException(val rank: Int, message: String) : RuntimeException(message)
