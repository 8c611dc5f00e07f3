package daphnis.cluster.desk

import daphnis.cluster.link.CrewMail
import daphnis.cluster.wire.Note
import daphnis.cluster.wire.Note.Phase
import daphnis.cluster.wire.Note.State
import daphnis.cluster.wire.Peer

/**
 * A node: it obeys one leader at a time, until that is lost or bids farewell, and works in one crew at a time.
 *
 * ```
 *   free --PREPARE--> READY --BEGIN--> WORKING --END, loss, failure--> ENDED
 *                       ^                                               |
 *                       +------------- PREPARE of a later crew ---------+
 * ```
 *
 * @param silence number of ticks after which a leader that says nothing is lost
 * @param begin starts the work with a mail as soon as the work before has returned
 * @param say takes a line for the user
 */
internal class NodeParty(
    private val self: Peer,
    private val greeter: Greeter,
    private val mails: Mails,
    private val courier: Courier,
    private val silence: Int,
    private val begin: (CrewMail) -> Unit,
    private val later: (() -> Unit) -> Unit,
    private val say: (String) -> Unit,
) : Party {
    /** The crew of the latest order. */
    private class Crew(val order: Note.Order, val mail: CrewMail) {
        var state = State.READY
        var words = ""
    }

    private var leader: Peer? = null
    private var session = 0L
    private var run = ""
    private var crew: Crew? = null

    /** Since the leader has said something. */
    private var ticks = 0

    override fun joined(node: Peer) = Unit

    override fun gone(peer: Peer, why: String) {
        greeter.forget(peer)
        if (peer == leader) {
            free("the leader ${peer.address} $why")
        } else {
            val crew = crew ?: return
            if (peer in crew.order.members) end(crew, "node ${peer.address} $why")
        }
    }

    override fun take(note: Note) {
        when (note) {
            is Note.Order -> obey(note)
            is Note.Farewell -> if (note.from == leader && note.session == session) free("run $run has ended")
            else -> Unit
        }
    }

    override fun tick() {
        val leader = leader ?: return
        ticks++
        if (ticks > silence) free("the leader ${leader.address} says nothing")
    }

    override fun end(why: String) {
        crew?.let { end(it, why) }
    }

    /** The work in the crew of [mail] has failed for the reason in [words]. */
    fun failed(mail: CrewMail, words: String) {
        val crew = crew?.takeIf { it.mail === mail } ?: return
        say("crew ${crew.order.number}: $words")
        end(crew, words)
    }

    private fun obey(order: Note.Order) {
        if (!greeter.knows(order.from, order.session)) {
            answer(order, State.STRANGER, "")
            return
        }
        if (order.phase == Phase.END) {
            crew?.takeIf { it.order.key == order.key }?.let { end(it, "the leader has ended the crew") }
            answer(order, State.ENDED, "")
            return
        }
        if (leader != null && leader != order.from) {
            answer(order, State.BUSY, "$run of ${leader!!.address}")
            return
        }
        ticks = 0
        if (order.phase == Phase.ASK) {
            answer(order, State.FREE, "")
            return
        }
        val crew = current(order) ?: return
        if (order.phase == Phase.BEGIN && crew.state == State.READY) {
            crew.state = State.WORKING
            // Only the order that prepares a crew names its members.
            val place = "node ${order.rank + 1} of ${crew.order.members.size}"
            say("computes $run of ${order.from.address} as $place")
            begin(crew.mail)
        }
        answer(order, crew.state, crew.words)
    }

    /** The crew of [order]; null when a later one is there. */
    private fun current(order: Note.Order): Crew? {
        val known = crew
        if (known != null && known.order.key == order.key) return known
        if (known != null && known.order.number >= order.number) return null
        // A crew begins with this node in it; another would send to a stranger.
        if (order.members.getOrNull(order.rank) != self) return null
        known?.let { mails.end(it.mail, "the node begins with another crew") }
        leader = order.from
        session = order.session
        run = order.run
        lateinit var mail: CrewMail
        mail = mails.open(order.key, order.rank, order.members, order.from) { why -> later { closed(mail, why) } }
        return Crew(order, mail).also { crew = it }
    }

    /** The work has closed the mail, or a link has. */
    private fun closed(mail: CrewMail, why: String) {
        mails.end(mail, why)
        crew?.takeIf { it.mail === mail }?.let { end(it, why) }
    }

    /** The crew is over; the leader hears why. */
    private fun end(crew: Crew, why: String) {
        mails.end(crew.mail, why)
        if (crew.state == State.ENDED) return
        crew.state = State.ENDED
        crew.words = why
        answer(crew.order, State.ENDED, why)
    }

    private fun free(why: String) {
        crew?.let { mails.end(it.mail, why) }
        crew = null
        leader = null
        say("$why; waiting for a run")
    }

    private fun answer(order: Note.Order, state: State, words: String) {
        courier.send(order.from.address, Note.Standing(self, order.session, order.key, state, words))
    }
}
