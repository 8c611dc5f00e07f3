package daphnis.cluster.link

import daphnis.core.cluster.Mail
import daphnis.core.cluster.MailClosedException
import java.nio.ByteBuffer
import java.util.concurrent.atomic.AtomicReference

/**
 * The mail of a member: a [Link] to each other member.
 *
 * @param crew key of the crew, which no other crew has
 * @param wire sends to the member with a rank; neither blocks nor calls back
 * @param closed is told the reason, once, when the member closes its mail or the mail cannot go on; not at [end]
 */
internal class CrewMail(
    val crew: Long,
    override val rank: Int,
    override val size: Int,
    limits: LinkLimits,
    wire: (Int, LinkMessage) -> Unit,
    private val closed: (String) -> Unit,
) : Mail {
    private val ending = AtomicReference<String>()
    private val links = Array(size + 1) { i ->
        val other = i + Mail.LEADER
        if (other == rank) null else Link(crew, rank, other, limits) { wire(other, it) }
    }

    override val isClosed: Boolean get() = ending.get() != null

    /** Why it is closed; null while it is open. */
    val reason: String? get() = ending.get()

    override fun send(to: Int, body: ByteBuffer) {
        val link = link(to)
        ending.get()?.let { throw MailClosedException(it) }
        link.send(body)
    }

    override fun receive(from: Int): ByteBuffer = link(from).receive()

    override fun close() {
        closeFor("the crew was ended by ${nameOf(rank)}")
    }

    /** Takes what has come for this member. Strangers are ignored. */
    fun accept(message: LinkMessage) {
        if (message.crew != crew || message.to != rank) return
        val link = links.getOrNull(message.from - Mail.LEADER) ?: return
        try {
            link.accept(message)
        } catch (e: LinkException) {
            closeFor("from ${nameOf(message.from)}: ${e.message}")
        } catch (_: OutOfMemoryError) {
            closeFor("no memory for a message of ${(message as? Chunk)?.length} bytes from ${nameOf(message.from)}")
        }
    }

    /** Bytes on the way, and bytes of whole messages that wait here, of all links together; for tests. */
    fun load(): Pair<Long, Long> {
        val loads = links.mapNotNull { it?.load() }
        return loads.sumOf { it.first } to loads.sumOf { it.second }
    }

    /** Sends anew what has waited too long. */
    fun tick() {
        for (link in links) link?.tick()
    }

    /** Ends the mail because the crew has ended for [reason]. @return whether it was open */
    fun end(reason: String): Boolean {
        if (!ending.compareAndSet(null, reason)) return false
        for (link in links) link?.end(reason)
        return true
    }

    private fun closeFor(reason: String) {
        if (end(reason)) closed(reason)
    }

    private fun link(other: Int): Link {
        require(other in Mail.LEADER until size && other != rank) {
            "rank is $other; it must be another than $rank and in ${Mail.LEADER}..${size - 1}"
        }
        return links[other - Mail.LEADER]!!
    }

    private fun nameOf(rank: Int) = if (rank == Mail.LEADER) "the leader" else "node $rank"
}
