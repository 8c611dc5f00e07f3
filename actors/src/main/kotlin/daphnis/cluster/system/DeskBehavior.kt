package daphnis.cluster.system

import daphnis.cluster.hosts.HostPort
import daphnis.cluster.settings.HostConfig
import daphnis.cluster.wire.Note
import daphnis.cluster.wire.Peer
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.actor.typed.javadsl.Adapter
import org.apache.pekko.actor.typed.javadsl.Behaviors
import org.apache.pekko.cluster.Cluster
import org.apache.pekko.cluster.ClusterEvent
import org.apache.pekko.cluster.Member
import org.apache.pekko.cluster.MemberStatus
import org.apache.pekko.cluster.UniqueAddress
import java.time.Duration

/** The actor through which a process hears of the others: what they write, and that they come and go. */
internal object DeskBehavior {
    /** What the desk does, on the actor's thread. */
    interface Desk {
        fun take(note: Note)

        fun up(member: Peer, isNode: Boolean)

        fun gone(member: Peer, why: String)

        fun tick()

        /** The desk itself has thrown [e]. */
        fun broken(e: Throwable)
    }

    /** Do [task] on the desk's thread. */
    class Do(val task: () -> Unit)

    private object Tick

    fun create(cluster: Cluster, desk: Desk): Behavior<Any> = Behaviors.setup { context ->
        val self = Adapter.toClassic(context.self)
        cluster.subscribe(
            self,
            ClusterEvent.initialStateAsEvents(),
            ClusterEvent.MemberEvent::class.java,
            ClusterEvent.`ClusterShuttingDown$`::class.java,
        )
        var isMember = true
        Behaviors.withTimers { timers ->
            timers.startTimerWithFixedDelay(Tick, TICK)
            Behaviors.receiveMessage { message ->
                try {
                    when (message) {
                        // What follows tells that all members are gone, which is not so: this process is.
                        is ClusterEvent.`ClusterShuttingDown$` -> isMember = false
                        is ClusterEvent.MemberEvent -> if (isMember) handle(message, desk)
                        else -> handle(message, desk)
                    }
                } catch (e: Throwable) {
                    desk.broken(e)
                }
                Behaviors.same()
            }
        }
    }

    private fun handle(message: Any, desk: Desk) {
        when (message) {
            is Note -> desk.take(message)
            is Do -> message.task()
            Tick -> desk.tick()
            is ClusterEvent.MemberUp -> desk.up(peer(message.member()), message.member().hasRole(NODE))
            is ClusterEvent.MemberLeft -> desk.gone(peer(message.member()), LEFT)
            is ClusterEvent.MemberDowned -> desk.gone(peer(message.member()), LOST)
            is ClusterEvent.MemberRemoved -> {
                val isDown = message.previousStatus() == MemberStatus.down()
                desk.gone(peer(message.member()), if (isDown) LOST else LEFT)
            }
        }
    }

    private fun peer(member: Member) = peer(member.uniqueAddress())

    fun peer(member: UniqueAddress): Peer {
        val address = member.address()
        val host = address.host.get().removeSurrounding("[", "]")
        return Peer(HostPort(host, address.port.get()), member.longUid())
    }

    /** The role of processes that work for leaders, and that of leaders. */
    const val NODE = HostConfig.NODE
    const val RUN = HostConfig.RUN
    private const val LEFT = "has left"
    private const val LOST = "was lost"
    val TICK: Duration = Duration.ofMillis(250)
}
