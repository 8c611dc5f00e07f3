package daphnis.cluster.system

import daphnis.cluster.desk.Courier
import daphnis.cluster.desk.Greeter
import daphnis.cluster.desk.Mails
import daphnis.cluster.desk.Party
import daphnis.cluster.wire.Note
import daphnis.cluster.wire.Peer
import daphnis.core.cluster.FleetException
import org.apache.pekko.actor.ActorSystem
import org.apache.pekko.actor.ExtendedActorSystem
import org.apache.pekko.actor.typed.ActorRef
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.cluster.Cluster
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ExecutionException

/**
 * A process of the cluster: Pekko's system with its actors, from [start] to [close]. What it does is its [Party].
 *
 * @param role [DeskBehavior.NODE] or [DeskBehavior.RUN]
 * @param build what must be the same in all processes
 * @param say takes lines for the user, from any thread
 */
internal class ClusterProcess(
    private val ground: Ground,
    private val role: String,
    private val build: Greeter.Build,
    private val say: (String) -> Unit,
) : AutoCloseable {
    private val joined = CompletableFuture<Unit>()
    private lateinit var system: ActorSystem
    private lateinit var cluster: Cluster
    private lateinit var desk: ActorRef<Any>
    private val actors = ArrayList<ActorRef<Any>>()

    /** The process, once it has started. */
    lateinit var self: Peer
        private set
    lateinit var mails: Mails
        private set
    lateinit var greeter: Greeter
        private set
    lateinit var courier: Courier
        private set

    /** Whether joining has begun; only the desk knows. */
    private var hasBegun = false

    @Volatile
    private var isMember = false

    @Volatile
    private var isClosing = false

    /** Why the process is no part of the cluster any more; empty when it was closed. */
    val ended: CompletableFuture<String> = CompletableFuture()

    /**
     * Listens, joins, and returns when this process is in the cluster.
     *
     * @param makeParty is called once, when the other properties are there
     * @throws FleetException when it cannot listen or join
     */
    fun start(makeParty: (ClusterProcess) -> Party) {
        system = ground.open(role)
        try {
            cluster = Cluster.get(system)
            self = DeskBehavior.peer(cluster.selfUniqueAddress())
            val wires = Wires(system as ExtendedActorSystem)
            courier = Courier { to, note -> wires.send(to, note) }
            mails = Mails(ground.limits) { to, message -> wires.send(to.address, message) }
            greeter = Greeter(self, build, ground.secret, ground.threads, courier, { isMember }, say)
            cluster.registerOnMemberRemoved { lose(REMOVED) }
            spawn(makeParty(this))
            awaitJoined()
        } catch (e: Throwable) {
            isClosing = true
            ground.end(system, actors)
            throw e
        }
    }

    /** For how many ticks of the desk another desk may say nothing. */
    val silence: Int get() = (ground.silence.toMillis() / DeskBehavior.TICK.toMillis()).toInt()

    /** Whether the others have given up this process. */
    val isRemoved: Boolean get() = ended.getNow("") == REMOVED

    /** Ends [start], which throws, if it has not returned yet. From any thread. */
    fun abandon() {
        joined.completeExceptionally(FleetException(LEFT))
    }

    /** Runs [task] on the desk's thread, soon; never when the process has ended. */
    fun later(task: () -> Unit) {
        desk.tell(DeskBehavior.Do(task))
    }

    /** Leaves the cluster, which takes a second or two. */
    override fun close() {
        if (isClosing) return
        isClosing = true
        if (isMember && !ended.isDone) ground.leave(cluster, ended)
        mails.endAll(LEFT)
        // The desk does what is left for it before it stops.
        ended.complete("")
        ground.end(system, actors)
    }

    private fun awaitJoined() {
        try {
            joined.get()
        } catch (e: ExecutionException) {
            throw e.cause ?: e
        }
    }

    /** Ends what hangs on the cluster. */
    private fun lose(why: String) {
        if (isClosing) {
            ended.complete("")
            return
        }
        if (!ended.complete(why)) return
        mails.endAll(why)
        joined.completeExceptionally(FleetException(why))
    }

    private fun spawn(party: Party) {
        fun fail(why: String) {
            joined.completeExceptionally(FleetException(why))
        }
        val entrance = ground.entrance(cluster, greeter, ::fail, say)
        greeter.called = { if (!isMember) entrance.called(it.address) }
        system.getWhenTerminated().thenRun { lose("the cluster's actors have ended") }
        desk = spawn(DeskBehavior.create(cluster, Desk(party, entrance)), "desk")
        spawn(PostBehavior.create(mails, isTimer = true), "post")
        spawn(PostBehavior.create(mails, isTimer = false), "receipts")
        ended.thenAccept { why -> later { party.end(why.ifEmpty { LEFT }) } }
        later {
            hasBegun = true
            entrance.start(System.nanoTime())
        }
    }

    private fun spawn(behavior: Behavior<Any>, name: String): ActorRef<Any> =
        ground.spawn(system, behavior, "daphnis-$name").also { actors += it }

    private inner class Desk(private val party: Party, private val entrance: Entrance) : DeskBehavior.Desk {
        override fun take(note: Note) {
            if (!greeter.take(note)) party.take(note)
        }

        override fun up(member: Peer, isNode: Boolean) {
            if (member == self) {
                isMember = true
                entrance.entered()
                joined.complete(Unit)
            }
            if (isNode && member != self) party.joined(member)
        }

        override fun gone(member: Peer, why: String) {
            if (member != self) party.gone(member, why)
        }

        override fun tick() {
            // On a busy machine a tick may overtake the beginning.
            if (hasBegun) entrance.tick(System.nanoTime())
            party.tick()
            greeter.tick()
        }

        override fun broken(e: Throwable) = lose("unexpected $e; this is a fault of daphnis")
    }

    private companion object {
        const val REMOVED = "this process was cut off from the others, or stopped for too long, and they go on without"
        const val LEFT = "this process has left the cluster"
    }
}
