package daphnis.cluster.desk

import daphnis.cluster.hosts.HostPort
import daphnis.cluster.link.CrewMail
import daphnis.cluster.link.LinkLimits
import daphnis.cluster.security.Secret
import daphnis.cluster.wire.Note
import daphnis.cluster.wire.Peer
import daphnis.core.cluster.BusyNode
import daphnis.core.cluster.FleetNode
import daphnis.core.cluster.Mail
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.util.concurrent.CompletableFuture
import kotlin.random.Random

/** A leader, or two, and nodes on one thread, whose notes get lost, doubled and swapped. */
class DesksTest {
    private val notes = ArrayList<Pair<HostPort, Note>>()
    private val desks = HashMap<HostPort, Desk>()

    private inner class Desk(number: Int, secret: Secret) {
        val self = Peer(HostPort("h", number), number.toLong())
        val tasks = ArrayDeque<() -> Unit>()
        val lines = ArrayList<String>()
        val begun = ArrayList<CrewMail>()
        val mails = Mails(LinkLimits()) { _, _ -> }
        private val courier = Courier { to, note -> notes += to to note }
        val greeter = Greeter(self, Greeter.Build("1", 1), secret, number, courier, { true }, lines::add)
        val node = NodeParty(self, greeter, mails, courier, SILENCE, begun::add, tasks::addLast, lines::add)
        val leader = LeaderParty(
            self, "run $number", listOf(), greeter, mails, courier, SILENCE, tasks::addLast, lines::add,
        )
        var party: Party = node

        init {
            desks[self.address] = this
        }

        fun take(note: Note) {
            if (!greeter.take(note)) party.take(note)
        }
    }

    private fun node(number: Int, secret: Secret = SECRET) = Desk(number, secret)

    private fun leader(number: Int) = Desk(number, SECRET).apply { party = leader }

    /** Some turns in which notes arrive, and sometimes not, or not in order. */
    private fun run(random: Random?, turns: Int = 50) = repeat(turns) {
        for (desk in desks.values) desk.party.tick()
        while (notes.isNotEmpty()) {
            val at = if (random == null) 0 else random.nextInt(minOf(3, notes.size))
            val (to, note) = notes[at]
            val fate = random?.nextInt(5)
            if (fate != 0) notes.removeAt(at)
            if (fate != 1) desks[to]?.take(note)
            for (desk in desks.values) while (desk.tasks.isNotEmpty()) desk.tasks.removeFirst()()
        }
    }

    private fun form(leader: Desk, nodes: List<FleetNode> = leader.leader.nodes()): CompletableFuture<Mail> =
        CompletableFuture<Mail>().also { leader.leader.form(nodes, it) }

    @ParameterizedTest
    @ValueSource(ints = [1, 2, 3, 4, 5])
    fun `crews form and end although notes are lost, doubled and swapped`(seed: Int) {
        val random = Random(seed)
        val nodes = List(3) { node(it + 1) }
        val leader = leader(9)
        for (node in nodes) leader.leader.joined(node.self)
        run(random)
        assertEquals(listOf("h:1", "h:2", "h:3"), leader.leader.nodes().map { it.name })
        assertEquals(listOf(1, 2, 3), leader.leader.nodes().map { it.threads })
        for (round in 0..<20) {
            val formed = form(leader, leader.leader.nodes().shuffled(random))
            run(random, 30)
            val mail = formed.get()
            assertFalse(mail.isClosed) { "seed $seed" }
            for (node in nodes) {
                assertEquals(round + 1, node.begun.size) { "seed $seed, ${node.self}" }
                assertFalse(node.begun.last().isClosed)
                assertEquals((mail as CrewMail).crew, node.begun.last().crew)
                assertEquals(1, node.mails.size)
            }
            when (round % 3) {
                0 -> mail.close()
                1 -> nodes[random.nextInt(3)].begun.last().close()
            }
            if (round % 3 == 2) continue
            run(random, 30)
            assertTrue(mail.isClosed)
            assertTrue(nodes.all { it.begun.last().isClosed && it.mails.size == 0 }) { "seed $seed" }
        }
    }

    @Test
    fun `a second leader is told whose the nodes are, until that one is gone`() {
        val node = node(1)
        val leaders = listOf(leader(8), leader(9))
        for (one in leaders) one.leader.joined(node.self)
        run(null, 3)
        val mail = form(leaders[0])
        run(null, 3)
        assertEquals(emptyList<FleetNode>(), leaders[1].leader.nodes())
        assertEquals(listOf(BusyNode("h:1", "run 8 of h:8")), leaders[1].leader.busy())
        assertEquals(emptyList<BusyNode>(), leaders[0].leader.busy())
        assertEquals(1, leaders[0].leader.nodes().size)
        node.node.gone(leaders[0].self, "was lost")
        assertTrue(node.begun.single().isClosed)
        assertEquals("the leader h:8 was lost", node.begun.single().reason)
        run(null, 3)
        assertEquals(emptyList<BusyNode>(), leaders[1].leader.busy())
        val again = form(leaders[1])
        run(null, 3)
        assertFalse(again.get().isClosed)
        assertTrue(mail.get() !== again.get())
    }

    @Test
    fun `of two leaders that want a node at one moment, the second finds its crew ended and the node busy`() {
        val nodes = listOf(node(1), node(2))
        val leaders = listOf(leader(8), leader(9))
        for (one in leaders) for (node in nodes) one.leader.joined(node.self)
        run(null, 3)
        val both = leaders.map { it.leader.nodes() }
        assertEquals(listOf(2, 2), both.map { it.size })
        val first = form(leaders[0], both[0].take(1))
        val second = form(leaders[1], both[1])
        run(null, 3)
        assertFalse(first.get().isClosed)
        assertTrue(second.get().isClosed)
        assertEquals("node h:1 works for the run run 8 of h:8", (second.get() as CrewMail).reason)
        assertEquals(listOf("h:2"), leaders[1].leader.nodes().map { it.name })
        val third = form(leaders[1])
        run(null, 3)
        assertFalse(third.get().isClosed)
        assertFalse(first.get().isClosed)
        leaders[0].leader.farewell()
        run(null, 3)
        assertEquals(listOf("h:1", "h:2"), leaders[1].leader.nodes().map { it.name })
    }

    @Test
    fun `a node that has forgotten a leader is no node until they have greeted each other anew`() {
        val node = node(1)
        val leader = leader(9)
        leader.leader.joined(node.self)
        run(null, 3)
        node.greeter.forget(leader.self)
        leader.leader.tick()
        val (_, ask) = notes.removeLast()
        node.take(ask)
        leader.take(notes.removeLast().second)
        assertEquals(emptyList<FleetNode>(), leader.leader.nodes())
        run(null, 3)
        assertEquals(1, leader.leader.nodes().size)
    }

    @Test
    fun `orders of a stranger, of an earlier crew, or for another are not obeyed`() {
        val node = node(1)
        val leader = leader(9)
        leader.leader.joined(node.self)
        run(null, 3)
        form(leader)
        run(null, 3)
        val seen = ArrayList<Note.Order>()
        leader.leader.tick()
        notes.mapNotNullTo(seen) { it.second as? Note.Order }
        notes.clear()
        val order = seen.single()
        fun changed(session: Long = order.session, number: Long = Long.MAX_VALUE, member: Peer = node.self) =
            Note.Order(
                order.from,
                session,
                number,
                5,
                Note.Phase.PREPARE,
                0,
                "x",
                listOf(member),
            )
        node.take(changed(session = order.session + 1))
        assertEquals(Note.State.STRANGER, (notes.single().second as Note.Standing).state)
        notes.clear()
        node.take(changed(number = 0))
        node.take(changed(member = Peer(node.self.address, 77)))
        assertTrue(notes.isEmpty())
        assertFalse(node.begun.single().isClosed)
        node.take(changed())
        assertTrue(node.begun.single().isClosed)
    }

    @Test
    fun `a node with another secret is no node, and one that is lost ends the crew`() {
        val nodes = listOf(node(1), node(2))
        val other = node(3, Secret.NONE)
        val leader = leader(9)
        for (node in nodes + other) leader.leader.joined(node.self)
        run(null, 3)
        assertEquals(2, leader.leader.nodes().size)
        assertEquals(1, other.lines.count { "same secret" in it })
        assertNotNull(leader.lines.find { it.startsWith("refused the node h:3") })
        val formed = form(leader)
        run(null, 3)
        leader.leader.gone(nodes[0].self, "was lost")
        assertTrue(formed.get().isClosed)
        run(null, 3)
        assertTrue(nodes[1].begun.single().isClosed)
        assertEquals(listOf("h:2"), leader.leader.nodes().map { it.name })
        leader.leader.farewell()
        run(null, 1)
        assertTrue("run run 9 has ended; waiting for a run" in nodes[1].lines)
        assertTrue(nodes[1].lines.any { Regex("computes run 9 of .* as node \\d of \\d").matches(it) })
    }

    @Test
    fun `a node whose desk says nothing any more is lost, and one whose leader says nothing is free`() {
        val nodes = listOf(node(1), node(2))
        val leader = leader(9)
        for (node in nodes) leader.leader.joined(node.self)
        run(null, 3)
        val first = form(leader)
        run(null, 3)
        desks.remove(nodes[0].self.address)
        run(null, SILENCE - 1)
        assertFalse(first.get().isClosed)
        run(null, 2)
        assertEquals("node h:1 says nothing", (first.get() as CrewMail).reason)
        assertEquals(listOf("h:2"), leader.leader.nodes().map { it.name })
        val second = form(leader)
        run(null, 3)
        assertFalse(second.get().isClosed)
        desks.remove(leader.self.address)
        run(null, SILENCE - 1)
        assertFalse(nodes[1].begun.last().isClosed)
        run(null, 2)
        assertTrue("the leader h:9 says nothing; waiting for a run" in nodes[1].lines)
        assertTrue(nodes[1].begun.last().isClosed)
    }

    @Test
    fun `a node that does not answer is not reckoned with until it does`() {
        val node = node(1)
        val leader = leader(9)
        leader.leader.joined(node.self)
        run(null, 3)
        desks.remove(node.self.address)
        run(null, 10)
        assertEquals(1, leader.leader.nodes().size)
        run(null, 5)
        assertEquals(0, leader.leader.nodes().size)
        desks[node.self.address] = node
        run(null, 2)
        assertEquals(1, leader.leader.nodes().size)
    }

    @Test
    fun `a leader begins anew when its last node has been gone for long, but not when it never had one`() {
        val lookout = Lookout(listOf(HostPort("h", 1)), leader(9).greeter)
        fun ticks(count: Int, hasNodes: Boolean) = repeat(count) { lookout.tick(hasNodes) }
        ticks(1000, hasNodes = false)
        assertFalse(lookout.mustBeginAnew)
        ticks(1, hasNodes = true)
        ticks(39, hasNodes = false)
        assertFalse(lookout.mustBeginAnew)
        ticks(1, hasNodes = false)
        assertTrue(lookout.mustBeginAnew)
        ticks(1, hasNodes = true)
        assertFalse(lookout.mustBeginAnew)
        val alone = Lookout(listOf(), leader(8).greeter)
        alone.tick(true)
        repeat(1000) { alone.tick(false) }
        assertFalse(alone.mustBeginAnew)
    }

    @Test
    fun `a leader without nodes finds another cluster by a process it was told of, but not by one answer`() {
        val other = node(1)
        val lookout = Lookout(listOf(other.self.address), leader(9).greeter)
        fun ticks(count: Int) = repeat(count) {
            lookout.tick(hasNodes = false)
            run(null, 1)
        }
        ticks(14)
        assertNull(lookout.found)
        ticks(1)
        assertEquals(other.self.address, lookout.found)
        lookout.tick(hasNodes = true)
        assertNull(lookout.found)
    }

    @Test
    fun `a node that ends says so to its leader`() {
        val node = node(1)
        val leader = leader(9)
        leader.leader.joined(node.self)
        run(null, 3)
        val formed = form(leader)
        run(null, 3)
        node.node.end("this process has left the cluster")
        run(null, 1)
        assertEquals("node h:1: this process has left the cluster", (formed.get() as CrewMail).reason)
    }

    private companion object {
        const val SILENCE = 60
        val SECRET = Secret.of("a secret of the tests", "test")
    }
}
