package daphnis.cluster.desk

import daphnis.cluster.desk.Greeter.Outcome
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.link.CrewMail
import daphnis.cluster.wire.Note
import daphnis.cluster.wire.Note.Phase
import daphnis.cluster.wire.Note.State
import daphnis.cluster.wire.Peer
import daphnis.core.cluster.BusyNode
import daphnis.core.cluster.FleetException
import daphnis.core.cluster.FleetNode
import daphnis.core.cluster.Mail
import java.util.concurrent.CompletableFuture
import kotlin.random.Random

/**
 * The leader of a run: it knows the nodes that have shown they know the secret, and makes crews of them. It tells each
 * node of the crew again and again what the crew is to do, so that nothing hangs on one note.
 *
 * @param run its name
 * @param others the processes it was told of when it joined
 * @param silence number of ticks after which a node of the crew that says nothing is none
 * @param later runs something on the desk's thread
 * @param say takes a line for the user
 */
internal class LeaderParty(
    private val self: Peer,
    private val run: String,
    others: List<HostPort>,
    private val greeter: Greeter,
    private val mails: Mails,
    private val courier: Courier,
    private val silence: Int,
    private val later: (() -> Unit) -> Unit,
    private val say: (String) -> Unit,
) : Party {
    private class Node(val peer: Peer) {
        /** Null until the two have greeted each other. */
        var friend: Outcome.Friend? = null
        var isRefused = false

        /** Whether it works for no other run; null until it has said so. */
        var isFree: Boolean? = null

        /** The other run that it works for. */
        var run = ""

        /** Since it has said something. */
        var ticks = 0
    }

    private class Crew(
        val number: Long,
        val members: List<Node>,
        val mail: CrewMail,
        val formed: CompletableFuture<Mail>,
    ) {
        var phase = Phase.PREPARE
        val ready = HashSet<Peer>()
    }

    private val lookout = Lookout(others, greeter)
    private val nodes = LinkedHashMap<Peer, Node>()
    private var crew: Crew? = null

    /** Greater than that of any earlier leader in this process. */
    private var number = System.currentTimeMillis() shl 20
    private var ending: String? = null

    /** Nodes that have not yet answered the order to end a crew, with the key of that. */
    private val partings = HashMap<Peer, Note.Order>()

    /** When there are no nodes here: a process of another cluster that knows the secret too. From any thread. */
    val elsewhere: HostPort? get() = lookout.found

    /** See [Lookout.mustBeginAnew]. From any thread. */
    val mustBeginAnew: Boolean get() = lookout.mustBeginAnew

    /** The nodes that can work, the first that joined first. */
    fun nodes(): List<FleetNode> {
        ending?.let { throw FleetException(it) }
        return nodes.values.filter { it.isFree == true }.mapNotNull { node ->
            node.friend?.let { FleetNode("${node.peer.address}", it.threads, node.peer.incarnation) }
        }
    }

    /** The nodes that work for other runs. */
    fun busy(): List<BusyNode> {
        ending?.let { throw FleetException(it) }
        return nodes.values.filter { it.isFree == false }.map { BusyNode("${it.peer.address}", it.run) }
    }

    /** Makes a crew of [wanted]; [formed] has its mail once all take mail. */
    fun form(wanted: List<FleetNode>, formed: CompletableFuture<Mail>) {
        ending?.let {
            formed.completeExceptionally(FleetException(it))
            return
        }
        crew?.let { end(it, "the leader begins with another crew") }
        val known = nodes.values.filter { it.friend != null }
            .associateBy { "${it.peer.address}" to it.peer.incarnation }
        val members = wanted.map { known[it.name to it.incarnation] }
        val missing = members.indexOf(null)
        val key = freshKey()
        lateinit var mail: CrewMail
        val peers = members.map { it?.peer ?: self }
        mail = mails.open(key, Mail.LEADER, peers, self) { why -> later { closed(mail, why) } }
        if (missing >= 0) {
            mails.end(mail, "node ${wanted[missing].name} has left")
            formed.complete(mail)
            return
        }
        val crew = Crew(++number, members.filterNotNull(), mail, formed)
        this.crew = crew
        for (node in crew.members) {
            partings.remove(node.peer)
            node.ticks = 0
        }
        order(crew)
        if (crew.members.isEmpty()) begin(crew)
    }

    override fun joined(node: Peer) {
        if (node in nodes) return
        val row = Node(node)
        nodes[node] = row
        greet(row)
    }

    override fun gone(peer: Peer, why: String) {
        greeter.forget(peer)
        partings.remove(peer)
        val node = nodes.remove(peer) ?: return
        crew?.takeIf { node in it.members }?.let { end(it, "node ${peer.address} $why") }
    }

    override fun take(note: Note) {
        if (note !is Note.Standing) return
        val node = nodes[note.from] ?: return
        if (node.friend?.session != note.session) return
        node.ticks = 0
        if (note.state == State.STRANGER) {
            node.friend = null
            node.isFree = null
        }
        if (note.key == NO_CREW) {
            answered(node, note)
            return
        }
        if (note.state == State.ENDED && partings[note.from]?.key == note.key) partings.remove(note.from)
        val crew = crew?.takeIf { it.mail.crew == note.key } ?: return
        when (note.state) {
            State.READY -> ready(crew, note.from)
            State.WORKING -> Unit
            State.ENDED -> end(crew, "node ${note.from.address}: ${note.words}")
            State.BUSY -> {
                occupied(node, note.words)
                end(crew, "node ${note.from.address} works for the run ${note.words}")
            }
            State.STRANGER -> end(crew, "node ${note.from.address} does not know this run any more")
            State.FREE -> Unit
        }
    }

    /** What [node] says without a crew. While it is in one of this run, that says more. */
    private fun answered(node: Node, note: Note.Standing) {
        if (crew?.let { node in it.members } == true) return
        when (note.state) {
            State.FREE -> node.isFree = true
            State.BUSY -> occupied(node, note.words)
            else -> Unit
        }
    }

    /** Its process is there, but its desk is not: it is no node until it answers again. */
    private fun silent(node: Node) {
        node.friend = null
        node.isFree = null
        crew?.let { end(it, "node ${node.peer.address} says nothing") }
    }

    private fun occupied(node: Node, run: String) {
        node.isFree = false
        node.run = run
    }

    private fun ask(node: Node) {
        val session = node.friend?.session ?: return
        courier.send(node.peer.address, Note.Order(self, session, 0, NO_CREW, Phase.ASK, 0, run, listOf()))
    }

    override fun tick() {
        lookout.tick(nodes.isNotEmpty())
        for (node in nodes.values) {
            if (node.friend == null && !node.isRefused) greet(node)
            if (crew?.let { node in it.members } == true) continue
            if (++node.ticks > UNHEARD) node.isFree = null
            ask(node)
        }
        crew?.let(::order)
        crew?.members?.find { ++it.ticks > silence }?.let(::silent)
        for ((peer, order) in partings) courier.send(peer.address, order)
    }

    override fun end(why: String) {
        if (ending == null) ending = why
        crew?.let { end(it, why) }
    }

    /** Ends the crew and leaves all nodes. */
    fun farewell() {
        end("the fleet is closed")
        for (node in nodes.values) node.friend?.let { courier.send(node.peer.address, Note.Farewell(self, it.session)) }
        nodes.clear()
    }

    private fun greet(node: Node) = greeter.greet(node.peer.address) { outcome ->
        when (outcome) {
            is Outcome.Friend -> if (outcome.peer == node.peer) {
                node.friend = outcome
                ask(node)
            }
            is Outcome.Refused -> {
                node.isRefused = true
                say("refused the node ${node.peer.address}: ${outcome.reason}")
            }
        }
    }

    private fun ready(crew: Crew, node: Peer) {
        crew.ready += node
        if (crew.phase == Phase.PREPARE && crew.ready.size == crew.members.size) begin(crew)
    }

    private fun begin(crew: Crew) {
        crew.phase = Phase.BEGIN
        order(crew)
        crew.formed.complete(crew.mail)
    }

    private fun closed(mail: CrewMail, why: String) {
        mails.end(mail, why)
        crew?.takeIf { it.mail === mail }?.let { end(it, why) }
    }

    private fun end(crew: Crew, why: String) {
        this.crew = null
        mails.end(crew.mail, why)
        crew.formed.complete(crew.mail)
        crew.phase = Phase.END
        for ((rank, node) in crew.members.withIndex()) {
            if (node.peer !in nodes) continue
            orderTo(crew, rank)?.let { partings[node.peer] = it }
        }
        order(crew)
    }

    private fun order(crew: Crew) {
        for ((rank, node) in crew.members.withIndex()) {
            orderTo(crew, rank)?.let { courier.send(node.peer.address, it) }
        }
    }

    private fun orderTo(crew: Crew, rank: Int): Note.Order? {
        val session = crew.members[rank].friend?.session ?: return null
        // Only who works needs to know the others.
        val peers = if (crew.phase == Phase.PREPARE) crew.members.map { it.peer } else listOf()
        return Note.Order(self, session, crew.number, crew.mail.crew, crew.phase, rank, run, peers)
    }

    private fun freshKey(): Long = generateSequence { Random.nextLong() }.first { it != NO_CREW }

    private companion object {
        /** The key of what concerns no crew. */
        const val NO_CREW = 0L

        /** A node that has not answered for so many ticks is not reckoned with. */
        const val UNHEARD = 12
    }
}
