package daphnis.core.cluster

import java.nio.ByteBuffer

/**
 * Messages among the members of one crew: nodes 0 until [size], which hold the spheres, and the [LEADER], which holds
 * the run. What one member sends to another arrives once, unchanged, and in the order in which it was sent, or the mail
 * of all members closes. One thread per member calls; [close] and [isClosed] may be called by any thread.
 */
public interface Mail : AutoCloseable {
    /** This member. */
    public val rank: Int

    /** Number of nodes, without the leader. */
    public val size: Int

    /**
     * Sends the remaining bytes of [body] to member [to], which is not this one. Returns without waiting for the
     * receiver; the bytes belong to the mail from then on, and must not be changed. They are at most [LONGEST].
     *
     * @throws MailClosedException after the end of the crew
     */
    public fun send(to: Int, body: ByteBuffer)

    /**
     * The next message from member [from]; waits for it. Its bytes belong to the caller.
     *
     * @throws MailClosedException when the crew ends before the message has come
     * @throws InterruptedException when the thread is interrupted
     */
    public fun receive(from: Int): ByteBuffer

    /** Whether the crew has ended. What was sent may still be received by nobody. */
    public val isClosed: Boolean

    /** Ends the crew: the mail of all its members closes. Closing twice is allowed. */
    override fun close()

    public companion object {
        /** The rank of the leader. */
        public const val LEADER: Int = -1

        /** The most bytes of a message. */
        public const val LONGEST: Int = 1 shl 30
    }
}

/** The crew has ended: a node was lost, the leader has ended it or was lost, or this node begins with another crew. */
public class MailClosedException(message: String) : RuntimeException(message)
