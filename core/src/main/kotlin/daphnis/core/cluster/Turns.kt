package daphnis.core.cluster

import java.nio.ByteBuffer

/**
 * What the nodes of a crew do together. In a turn each says something to all others, and may say something to single
 * ones ([Spread]). All make the same turns in the same order. A node that has failed says so in place of its next
 * message ([fail]); then the turn throws [NodeFailedException] at all others. After that all are at the same place
 * again. What fails while messages go around, such as for lack of memory, is a [TornTurnException]: nobody knows who
 * has heard what, and the crew has to end.
 */
internal class Turns(mail: Mail) {
    val rank: Int = mail.rank
    val size: Int = mail.size
    private val spread = Spread(mail)

    /** Bytes that this node has sent to others. */
    val bytesSent: Long get() = spread.bytesSent

    /**
     * One turn. [writeOne] adds what the node of a rank alone is to know, if anything; after it [writeAll] adds what
     * all are to know. [readOne] takes what others have said to this node, then [readAll] what they have said to all,
     * in the order of ranks.
     */
    inline fun exchange(
        writeOne: (rank: Int, MessageWriter) -> Unit,
        writeAll: MessageWriter.() -> Unit,
        readOne: (rank: Int, ByteBuffer) -> Unit,
        readAll: (rank: Int, ByteBuffer) -> Unit,
    ) {
        // All are written before the first is sent, so that a failure says so to all.
        val toOne = Array(size) { to ->
            if (to == rank) null else Spread.forOne(Spread.forOne().also { writeOne(to, it) })
        }
        val heard = around(MessageWriter().byte(FINE).apply(writeAll), toOne)
        for (from in others()) heard.toOne[from]?.let { readOne(from, it) }
        for (from in others()) readAll(from, heard.toAll[from])
    }

    /** The same with nothing for single ones. */
    inline fun tell(message: MessageWriter.() -> Unit, read: (rank: Int, ByteBuffer) -> Unit) {
        if (size == 1) return
        val heard = around(MessageWriter().byte(FINE).apply(message), arrayOfNulls(size))
        for (from in others()) read(from, heard.toAll[from])
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
        send(MessageWriter().byte(FAILED).text(cause.toString()).message(), arrayOfNulls(size))
    }

    fun others(): List<Int> = (0 until size).filter { it != rank }

    fun around(toAll: MessageWriter, toOne: Array<ByteBuffer?>): Spread.Heard {
        val heard = send(toAll.message(), toOne)
        // All was received, whatever is in it, so that the next turn begins with its own messages.
        for (from in 0 until size) {
            val message = heard.toAll[from]
            if (message.get().toInt() != FINE) throw NodeFailedException(from, message.text())
        }
        return heard
    }

    private fun send(toAll: ByteBuffer, toOne: Array<ByteBuffer?>): Spread.Heard = try {
        spread.around(toAll, toOne)
    } catch (e: MailClosedException) {
        throw e
    } catch (e: InterruptedException) {
        throw e
    } catch (e: Throwable) {
        throw if (spread.hasBegun) TornTurnException(e) else e
    }

    companion object {
        const val FINE = 0
        const val FAILED = 1
    }
}

/** Another node has failed in the turn: that of [rank]. */
internal class NodeFailedException(val rank: Int, message: String) : RuntimeException(message)

/** A turn has failed on this node after the first of its messages was sent. */
internal class TornTurnException(cause: Throwable) : RuntimeException(cause.toString(), cause)
