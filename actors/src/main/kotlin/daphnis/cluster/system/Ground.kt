package daphnis.cluster.system

import daphnis.cluster.desk.Greeter
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.link.LinkLimits
import daphnis.cluster.security.Secret
import org.apache.pekko.actor.ActorSystem
import org.apache.pekko.actor.typed.ActorRef
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.cluster.Cluster
import java.time.Duration
import java.util.concurrent.CompletableFuture

/** What a process of the cluster stands on: its own actor system ([OwnGround]), or that of a host ([HostGround]). */
internal interface Ground {
    val limits: LinkLimits

    /** How long the desk of another process may say nothing, although the cluster still has the process. */
    val silence: Duration
    val secret: Secret
    val threads: Int

    /** What is not guarded without TLS, in a line for the user; null where it is, or is the business of a host. */
    val openness: String?

    /**
     * The system, for a process with the [role].
     *
     * @throws daphnis.core.cluster.FleetException when it cannot listen
     * @throws IllegalArgumentException when a host's system lacks what is needed
     */
    fun open(role: String): ActorSystem

    /** How the process of [cluster] becomes a member; [fail] takes the reason why it does not, [say] lines. */
    fun entrance(cluster: Cluster, greeter: Greeter, fail: (String) -> Unit, say: (String) -> Unit): Entrance

    /** An actor of the process, to which others write by the path /system/[name]. */
    fun spawn(system: ActorSystem, behavior: Behavior<Any>, name: String): ActorRef<Any>

    /** Leaves [cluster], if that is the process's own business; waits for [ended], not for ever. */
    fun leave(cluster: Cluster, ended: CompletableFuture<String>)

    /** Ends what is the process's own of [system]: its [actors] at least. */
    fun end(system: ActorSystem, actors: List<ActorRef<Any>>)
}

/** The way into a cluster. Only the desk calls; times in nanoseconds. */
internal interface Entrance {
    fun start(now: Long)

    fun tick(now: Long)

    /** This process is in the cluster. */
    fun entered()

    /** A process of a cluster, which knows the secret, has called from [address]. */
    fun called(address: HostPort)
}
