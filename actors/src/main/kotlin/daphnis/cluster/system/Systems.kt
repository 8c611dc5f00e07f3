package daphnis.cluster.system

import com.typesafe.config.Config
import daphnis.cluster.settings.ClusterSettings
import daphnis.cluster.wire.SealedMembership
import daphnis.core.cluster.FleetException
import org.apache.pekko.actor.ActorSystem
import org.apache.pekko.actor.BootstrapSetup
import org.apache.pekko.actor.ExtendedActorSystem
import org.apache.pekko.actor.InvalidActorNameException
import org.apache.pekko.actor.setup.ActorSystemSetup
import org.apache.pekko.actor.typed.ActorRef
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.actor.typed.javadsl.Adapter
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/** Pekko's systems of this package: their start, with errors for the user, and their end. */
internal object Systems {
    /** @throws FleetException when it cannot listen */
    fun start(settings: ClusterSettings, config: Config): ActorSystem = try {
        val membership = SealedMembership.setup(settings.secret)
        ActorSystem.create("daphnis", ActorSystemSetup.create(BootstrapSetup.create(config), membership))
    } catch (e: Exception) {
        val where = "port ${settings.port} of ${settings.bind ?: settings.host}"
        val chain = generateSequence<Throwable>(e) { it.cause }.joinToString { "${it.javaClass.name}: ${it.message}" }
        throw when {
            "in use" in chain -> FleetException("$where is in use; name another port, or 0 for any that is free", e)
            "BindException" in chain || "bind" in chain.lowercase() -> FleetException(
                "cannot listen on $where; is that an address of this machine?",
                e,
            )
            else -> FleetException("the cluster cannot start: ${e.message}", e)
        }
    }

    /**
     * An actor with the path /system/[name], where also systems with a guardian of their own let it live.
     *
     * @throws IllegalStateException when there is one
     */
    fun spawn(system: ActorSystem, behavior: Behavior<Any>, name: String): ActorRef<Any> = try {
        val actor = (system as ExtendedActorSystem).systemActorOf(Adapter.props { behavior }, name)
        Adapter.toTyped(actor)
    } catch (e: InvalidActorNameException) {
        throw IllegalStateException("the actor system '${system.name()}' has an actor $name already", e)
    }

    /** Ends [system] and waits for that, not for ever. */
    fun end(system: ActorSystem) {
        system.terminate()
        try {
            system.getWhenTerminated().toCompletableFuture().get(END_SECONDS, TimeUnit.SECONDS)
        } catch (_: TimeoutException) {
            // Its threads are daemons.
        }
    }

    private const val END_SECONDS = 10L
}
