package daphnis.cluster.system

import org.apache.pekko.actor.AbstractExtensionId
import org.apache.pekko.actor.ActorSystem
import org.apache.pekko.actor.ExtendedActorSystem
import org.apache.pekko.actor.Extension
import org.apache.pekko.actor.typed.ActorRef
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.actor.typed.javadsl.Behaviors
import java.util.concurrent.ConcurrentHashMap

/**
 * The actors at the paths by which others write to a host's system. They stay as long as the system, because Pekko
 * remembers which actor lives at a path, and hand on what comes to the actors of the node or run that lives there now.
 */
internal class Fronts private constructor(private val system: ExtendedActorSystem) : Extension {
    private val fronts = HashMap<String, ActorRef<Any>>()
    private val tenants = ConcurrentHashMap<String, ActorRef<Any>>()
    private var count = 0

    /**
     * An actor that gets what comes to the [name], until [leave].
     *
     * @throws IllegalStateException when another one does
     */
    @Synchronized
    fun enter(behavior: Behavior<Any>, name: String): ActorRef<Any> {
        check(!tenants.containsKey(name)) {
            "the actor system '${system.name()}' has a node or a run of daphnis already"
        }
        fronts.getOrPut(name) { Systems.spawn(system, front(name), name) }
        return Systems.spawn(system, behavior, "$name-${count++}").also { tenants[name] = it }
    }

    @Synchronized
    fun leave(actors: List<ActorRef<Any>>) {
        tenants.values.removeAll(actors.toSet())
    }

    private fun front(name: String): Behavior<Any> = Behaviors.receiveMessage { message ->
        tenants[name]?.tell(message)
        Behaviors.same()
    }

    companion object Id : AbstractExtensionId<Fronts>() {
        override fun createExtension(system: ExtendedActorSystem): Fronts = Fronts(system)

        /** Those of [system], one set for all who ask. */
        fun of(system: ActorSystem): Fronts = get(system)
    }
}
