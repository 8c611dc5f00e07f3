package daphnis.cluster

import daphnis.cluster.desk.Greeter
import daphnis.cluster.desk.LeaderParty
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.security.Secret
import daphnis.cluster.settings.ClusterSettings
import daphnis.cluster.system.ClusterProcess
import daphnis.cluster.system.DeskBehavior
import daphnis.cluster.system.Ground
import daphnis.cluster.system.HostGround
import daphnis.cluster.system.OwnGround
import daphnis.cluster.system.Protocol
import daphnis.core.cluster.BusyNode
import daphnis.core.cluster.Fleet
import daphnis.core.cluster.FleetException
import daphnis.core.cluster.FleetNode
import daphnis.core.cluster.Mail
import daphnis.core.cluster.MailClosedException
import daphnis.core.input.oneLine
import org.apache.pekko.actor.ActorSystem
import java.time.Duration
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException
import java.util.function.Consumer

/**
 * The nodes of a cluster that this process has joined as the leader of a run. Any thread may call.
 *
 * When the others have given up this process, which was cut off or stood still for too long, it joins them again. It
 * also does when it has no nodes, and those that it was told of are in another cluster, as after all have been started
 * anew. When its last node has been gone for ten seconds, it begins a cluster anew, since nodes that it has given up
 * would not hear it any more. All this happens in [nodes].
 */
public class ClusterFleet private constructor(
    private val settings: ClusterSettings?,
    private val ground: (ClusterSettings?) -> Ground,
    private val run: String,
    private val build: Greeter.Build,
    private val lines: Consumer<String>,
) : Fleet {
    /** One stay in a cluster. */
    private class Stay(val process: ClusterProcess, val party: LeaderParty, val canComeBack: Boolean) {
        val isOver: Boolean
            get() = canComeBack && (process.isRemoved || party.elsewhere != null || party.mustBeginAnew)
    }

    /** Guards [stay] against two threads that come back at once, or one that closes. */
    private val coming = Any()

    @Volatile
    private var entering: ClusterProcess? = null

    @Volatile
    private var isClosed = false

    /** Where nodes were. */
    private val known = LinkedHashSet<HostPort>()

    @Volatile
    private var stay = enter(settings)

    /** Where this process listens; nodes can join by it. */
    public val address: HostPort get() = stay.process.self.address

    /**
     * The nodes that can work now; may take as long as joining does.
     *
     * @throws FleetException when this process is no part of the cluster any more, and cannot come back
     */
    override fun nodes(): List<FleetNode> {
        while (true) {
            if (stay.isOver) comeBack()
            val stay = stay
            try {
                return ask(stay) { it.complete(stay.party.nodes()) }
            } catch (e: FleetException) {
                if (isClosed || !stay.isOver) throw e
            }
        }
    }

    /** @throws FleetException when this process is no part of the cluster any more */
    override fun busy(): List<BusyNode> {
        val stay = stay
        return try {
            ask(stay) { it.complete(stay.party.busy()) }
        } catch (e: FleetException) {
            if (!isClosed && stay.isOver) emptyList() else throw e
        }
    }

    /**
     * Waits until all have answered, for a minute at most.
     *
     * @throws FleetException when a node does not answer
     */
    override fun form(nodes: List<FleetNode>): Mail {
        val stay = stay
        synchronized(known) { nodes.mapTo(known) { HostPort.parse(it.name, "node") } }
        return try {
            ask(stay) { stay.party.form(nodes, it) }
        } catch (e: FleetException) {
            throw if (!isClosed && stay.isOver) MailClosedException(e.message.orEmpty()) else e
        }
    }

    override fun close() {
        isClosed = true
        entering?.abandon()
        synchronized(coming) {
            val process = stay.process
            try {
                if (!process.ended.isDone) ask(stay) { it.complete(stay.party.farewell()) }
            } catch (_: FleetException) {
                // The nodes see that this process is gone.
            }
            process.close()
        }
    }

    private fun comeBack(): Unit = synchronized(coming) {
        val old = stay
        val first = settings ?: return
        if (isClosed) throw FleetException(CLOSED)
        if (!old.isOver) return
        val elsewhere = old.party.elsewhere
        val beginsAnew = elsewhere == null && !old.process.isRemoved
        val why = when {
            elsewhere != null -> "there is no node here, but one at $elsewhere; joining again"
            beginsAnew -> "no node is left; looking for nodes anew"
            else -> "this process was cut off from the nodes, or stopped for too long; joining again"
        }
        say(why)
        old.process.close()
        val others = synchronized(known) { first.join + known } - address
        // The first that is named may begin a cluster.
        val join = if (beginsAnew) listOf(address) + others else others
        stay = enter(first.copy(port = address.port, join = join.distinct()))
    }

    private fun enter(settings: ClusterSettings?): Stay {
        val process = ClusterProcess(ground(settings), DeskBehavior.RUN, build, ::say)
        lateinit var party: LeaderParty
        entering = process
        try {
            if (isClosed) throw FleetException(CLOSED)
            process.start {
                val others = settings?.join.orEmpty() - it.self.address
                party = LeaderParty(
                    it.self, run, others, it.greeter, it.mails, it.courier, it.silence, it::later, ::say,
                )
                party
            }
        } finally {
            entering = null
        }
        return Stay(process, party, settings != null)
    }

    /** Words of others stand in some lines. */
    private fun say(line: String): Unit = lines.accept(oneLine(line))

    /** Has [task] complete a future on the desk's thread, and waits for that. */
    private fun <T> ask(stay: Stay, task: (CompletableFuture<T>) -> Unit): T {
        val answer = CompletableFuture<T>()
        stay.process.later {
            try {
                task(answer)
            } catch (e: FleetException) {
                answer.completeExceptionally(e)
            }
        }
        try {
            CompletableFuture.anyOf(answer, stay.process.ended).get(PATIENCE, TimeUnit.SECONDS)
        } catch (e: ExecutionException) {
            // As an exception of this thread, with the other as its cause.
            throw FleetException(e.cause?.message.orEmpty(), e.cause)
        } catch (_: TimeoutException) {
            throw FleetException("the nodes have not answered for $PATIENCE s")
        }
        if (answer.isDone && !answer.isCompletedExceptionally) return answer.get()
        throw FleetException(stay.process.ended.getNow("").ifEmpty { CLOSED })
    }

    public companion object {
        private const val PATIENCE = 60L
        private const val CLOSED = "the fleet is closed"

        /**
         * Joins the cluster of [ClusterSettings.join], or begins one, for the run with the name [run].
         *
         * @param lines takes lines for the user, from any thread: nodes that were refused
         * @throws FleetException when this process cannot listen, nobody answers, or it is refused
         * @throws daphnis.core.input.InputException when the settings cannot be right
         */
        @JvmStatic
        public fun join(settings: ClusterSettings, run: String, lines: Consumer<String>): ClusterFleet =
            join(settings, run, Protocol.build, lines)

        /**
         * Lets the leader of the run with the name [run] live in [system], a host's actor system with the settings of
         * [HostConfig.run][daphnis.cluster.settings.HostConfig.run]. It lives until [close], which ends neither the
         * system nor its place in the cluster; then the next may. It does not come back by itself when the others have
         * given up the system, since only its host can start another.
         *
         * @param secret that all nodes and runs of the cluster were given
         * @param lines takes lines for the user, from any thread: nodes that were refused
         * @throws FleetException when the system is in no cluster within a minute
         * @throws IllegalArgumentException when the system lacks what is needed; the message says what
         * @throws IllegalStateException when a node or a run lives there already
         */
        @JvmStatic
        public fun on(system: ActorSystem, secret: Secret, run: String, lines: Consumer<String>): ClusterFleet {
            val ground = HostGround(system, secret, 1, Duration.ofSeconds(PATIENCE))
            return ClusterFleet(null, { ground }, run, Protocol.build, lines)
        }

        internal fun join(
            settings: ClusterSettings,
            run: String,
            build: Greeter.Build,
            lines: Consumer<String>,
        ): ClusterFleet = ClusterFleet(settings, { OwnGround(it!!) }, run, build, lines)
    }
}
