package daphnis.cluster.desk

import daphnis.cluster.link.CrewMail
import daphnis.cluster.link.LinkLimits
import daphnis.cluster.link.LinkMessage
import daphnis.cluster.wire.Peer
import java.util.concurrent.ConcurrentHashMap

/**
 * The open mails of a process by the key of their crew. The desk opens and ends them, the network brings what has come.
 *
 * @param wire sends to another process; neither blocks nor calls back
 */
internal class Mails(private val limits: LinkLimits, private val wire: (Peer, LinkMessage) -> Unit) {
    private val open = ConcurrentHashMap<Long, CrewMail>()

    /**
     * The mail of the member [rank] in the crew of [nodes] under [leader].
     *
     * @param closed is told the reason when the member closes the mail, or the mail cannot go on
     */
    fun open(key: Long, rank: Int, nodes: List<Peer>, leader: Peer, closed: (String) -> Unit): CrewMail {
        val send = { to: Int, message: LinkMessage -> wire(if (to < 0) leader else nodes[to], message) }
        return CrewMail(key, rank, nodes.size, limits, send, closed).also { open[key] = it }
    }

    /** Ends [mail]. @return whether it was open */
    fun end(mail: CrewMail, reason: String): Boolean {
        open.remove(mail.crew)
        return mail.end(reason)
    }

    /** Ends all. */
    fun endAll(reason: String) {
        for (mail in open.values) end(mail, reason)
    }

    /** What has come for a crew that is not there is dropped: it is sent anew, if somebody waits for it. */
    fun accept(message: LinkMessage) {
        open[message.crew]?.accept(message)
    }

    fun tick() {
        for (mail in open.values) mail.tick()
    }

    /** How many are open; for tests. */
    val size: Int get() = open.size
}
