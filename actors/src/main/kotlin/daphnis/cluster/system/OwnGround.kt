package daphnis.cluster.system

import daphnis.cluster.desk.Greeter
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.link.LinkLimits
import daphnis.cluster.security.Secret
import daphnis.cluster.settings.ClusterSettings
import daphnis.cluster.settings.Effective
import org.apache.pekko.actor.ActorSystem
import org.apache.pekko.actor.typed.ActorRef
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.cluster.Cluster
import java.time.Duration
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/** An actor system that lives and dies with the process of the cluster, and joins and leaves as [settings] say. */
internal class OwnGround(private val settings: ClusterSettings) : Ground {
    private val effective = Effective(settings)
    override val limits: LinkLimits get() = effective.limits
    override val silence: Duration get() = effective.silence
    override val secret: Secret get() = settings.secret
    override val threads: Int get() = settings.threads

    override val openness: String?
        get() = when {
            effective.isTls -> null
            secret.isNone -> "no secret and no TLS: every program of this machine can join this node, and end it"
            else -> "no TLS: the secret keeps strangers out, but who is on the network can listen, and disturb"
        }

    override fun open(role: String): ActorSystem = Systems.start(settings, effective.config(listOf(role)))

    override fun entrance(
        cluster: Cluster,
        greeter: Greeter,
        fail: (String) -> Unit,
        say: (String) -> Unit,
    ): Entrance {
        val self = DeskBehavior.peer(cluster.selfUniqueAddress()).address
        val others = settings.join.filter { it != self }
        val mayBegin = settings.join.firstOrNull()?.let { it == self } ?: true
        return Joining(others, mayBegin, settings.joinWithin, greeter, { enter(cluster, it) }, fail, say)
    }

    private fun enter(cluster: Cluster, other: HostPort?) {
        val address = cluster.selfAddress()
        if (other == null) {
            cluster.join(address)
            return
        }
        val host = scala.Option.apply(other.uriHost)
        val port = scala.Option.apply(other.port as Any)
        cluster.joinSeedNodes(listOf(address.copy(address.protocol(), address.system(), host, port)))
    }

    override fun spawn(system: ActorSystem, behavior: Behavior<Any>, name: String): ActorRef<Any> =
        Systems.spawn(system, behavior, name)

    override fun leave(cluster: Cluster, ended: CompletableFuture<String>) {
        cluster.leave(cluster.selfAddress())
        try {
            ended.get(LEAVE_SECONDS, TimeUnit.SECONDS)
        } catch (_: TimeoutException) {
            // The others find out.
        }
    }

    override fun end(system: ActorSystem, actors: List<ActorRef<Any>>): Unit = Systems.end(system)

    private companion object {
        const val LEAVE_SECONDS = 8L
    }
}
