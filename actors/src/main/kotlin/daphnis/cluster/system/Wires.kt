package daphnis.cluster.system

import daphnis.cluster.hosts.HostPort
import daphnis.cluster.link.LinkMessage
import daphnis.cluster.link.Receipt
import daphnis.cluster.wire.Note
import org.apache.pekko.actor.ActorRef
import org.apache.pekko.actor.ExtendedActorSystem
import java.util.concurrent.ConcurrentHashMap

/**
 * The ways to other processes. Chunks go to the actor "daphnis-post", on the connection for large messages; receipts
 * to another on the connection that chunks do not fill; notes to the desk. Sending puts a message into Pekko's queue,
 * from any thread; it neither waits nor fails.
 */
internal class Wires(private val system: ExtendedActorSystem) {
    private val posts = Way("daphnis-post")
    private val receipts = Way("daphnis-receipts")
    private val desks = Way("daphnis-desk")

    fun send(to: HostPort, message: LinkMessage) {
        val way = if (message is Receipt) receipts else posts
        way.to(to).tell(message, ActorRef.noSender())
    }

    fun send(to: HostPort, note: Note) {
        // Pekko sends nothing else to an address where a process was given up: another may be there by now.
        if (note is Note.Hello) {
            system.actorSelection(desks.path(to)).tell(note, ActorRef.noSender())
        } else {
            desks.to(to).tell(note, ActorRef.noSender())
        }
    }

    /** The actor with a name in each process. */
    private inner class Way(private val name: String) {
        private val actors = ConcurrentHashMap<HostPort, ActorRef>()

        fun to(address: HostPort): ActorRef = actors.computeIfAbsent(address) {
            system.provider().resolveActorRef(path(it))
        }

        fun path(address: HostPort): String =
            "${system.provider().defaultAddress.protocol()}://${system.name()}@$address/system/$name"
    }
}
