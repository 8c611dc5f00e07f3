package daphnis.cluster.system

import daphnis.cluster.desk.Greeter
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.link.LinkLimits
import daphnis.cluster.security.Secret
import daphnis.cluster.settings.HostConfig
import daphnis.cluster.wire.FrameSerializer
import daphnis.cluster.wire.Note
import daphnis.cluster.wire.Peer
import org.apache.pekko.actor.ActorSystem
import org.apache.pekko.actor.PoisonPill
import org.apache.pekko.actor.typed.ActorRef
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.actor.typed.javadsl.Adapter
import org.apache.pekko.cluster.Cluster
import org.apache.pekko.pattern.Patterns
import org.apache.pekko.serialization.SerializationExtension
import java.io.NotSerializableException
import java.time.Duration
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException
import org.apache.pekko.actor.ActorRef as ClassicRef

/**
 * A host's actor [system]. It is neither started nor ended here, and joins and leaves a cluster as its host likes.
 *
 * @param within how long to wait until the system is in a cluster
 */
internal class HostGround(
    private val system: ActorSystem,
    override val secret: Secret,
    override val threads: Int,
    private val within: Duration,
) : Ground {
    private val config = HostConfig.behind(system.settings().config())
    override val limits: LinkLimits get() = HostConfig.limits(config)
    override val silence: Duration get() = HostConfig.silence(config)

    override val openness: String? get() = null

    override fun open(role: String): ActorSystem {
        val name = "the actor system '${system.name()}'"
        val problem = HostConfig.problem(config, role)
        require(problem == null) { "$name $problem; daphnis.cluster.settings.HostConfig has all that is needed" }
        require(isSerialized()) { "$name has another serializer than ${FrameSerializer::class.java.name} for notes" }
        return system
    }

    private fun isSerialized(): Boolean = try {
        val note = Note.Farewell(Peer(HostPort("localhost", 1), 1), 1)
        SerializationExtension.get(system).findSerializerFor(note) is FrameSerializer
    } catch (_: NotSerializableException) {
        false
    }

    override fun entrance(
        cluster: Cluster,
        greeter: Greeter,
        fail: (String) -> Unit,
        say: (String) -> Unit,
    ): Entrance = object : Entrance {
        private var begun = 0L
        private var isOver = false

        override fun start(now: Long) {
            begun = now
        }

        override fun tick(now: Long) {
            if (isOver || now - begun <= within.toNanos()) return
            isOver = true
            fail("the actor system '${system.name()}' is in no cluster since ${within.toSeconds()} s; it must join one")
        }

        override fun entered() {
            isOver = true
        }

        override fun called(address: HostPort) = Unit
    }

    override fun spawn(system: ActorSystem, behavior: Behavior<Any>, name: String): ActorRef<Any> =
        Fronts.of(system).enter(behavior, name)

    override fun leave(cluster: Cluster, ended: CompletableFuture<String>): Unit = Unit

    override fun end(system: ActorSystem, actors: List<ActorRef<Any>>) {
        Fronts.of(system).leave(actors)
        for (actor in actors) stop(Adapter.toClassic(actor))
    }

    private fun stop(actor: ClassicRef) {
        try {
            val stopped = Patterns.gracefulStop(actor, STOP, PoisonPill.getInstance())
            stopped.toCompletableFuture().get(STOP.toSeconds(), TimeUnit.SECONDS)
        } catch (_: TimeoutException) {
            // It stops when the host's threads are free.
        } catch (_: ExecutionException) {
            // The same.
        } catch (_: IllegalStateException) {
            // The host's system is ending, has no timers any more, and ends its actors itself.
        }
    }

    private companion object {
        val STOP: Duration = Duration.ofSeconds(10)
    }
}
