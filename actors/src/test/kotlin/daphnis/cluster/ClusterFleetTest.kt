package daphnis.cluster

import daphnis.cluster.TestedFleet.Companion.await
import daphnis.cluster.TestedFleet.Companion.awaitThat
import daphnis.cluster.link.CrewMail
import daphnis.core.FreePorts
import daphnis.core.cluster.BusyNode
import daphnis.core.cluster.FleetException
import daphnis.core.cluster.Mail
import daphnis.core.cluster.MailClosedException
import daphnis.core.cluster.NodeWork
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.nio.ByteBuffer
import java.nio.file.Path
import java.util.concurrent.CountDownLatch
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicReference
import kotlin.random.Random

/** Crews of nodes in one JVM, over Pekko. The time-out is for what hangs. */
@Tag("jdk-neutral")
@Timeout(300)
@Tag("thorough")
class ClusterFleetTest {
    @TempDir
    lateinit var folder: Path

    private val tested by lazy { TestedFleet(folder) }

    @AfterEach
    fun close() = tested.close()

    @Test
    fun `messages of all lengths go around, in crew after crew`() {
        repeat(2) { tested.node() }
        val fleet = tested.leader()
        val nodes = await(fleet, 2)
        assertEquals(listOf(2, 2), nodes.map { it.threads })
        val mail = fleet.form(nodes)
        assertEquals(2, mail.size)
        val random = Random(1)
        for (length in listOf(0, 1, 1000, 262_144, 262_145, 10_000_000)) Echo.around(mail, random.nextBytes(length))
        var latest = mail
        repeat(200) {
            val before = latest
            latest = fleet.form(if (it % 3 == 0) nodes.take(1) else nodes.reversed())
            assertTrue(before.isClosed)
            Echo.around(latest, random.nextBytes(it))
        }
        assertFalse(latest.isClosed)
    }

    @Test
    fun `a lost node closes the mail of the crew, and the others go on in the next`() {
        repeat(2) { tested.node() }
        val lost = tested.node()
        val fleet = tested.leader()
        val mail = fleet.form(await(fleet, 3))
        Echo.around(mail, ByteArray(10))
        lost.close()
        val e = assertThrows(MailClosedException::class.java) { mail.receive(2) }
        // It is heard from the cluster, from the other node, or from the lost one itself, whichever comes first.
        val left = Regex("(node .*: )?node ${lost.address}(: this process)? has left( the cluster)?")
        assertTrue(left.matches(e.message!!)) { e.message }
        Echo.around(fleet.form(await(fleet, 2)), ByteArray(10))
    }

    @Test
    fun `a node that joins later is seen, and one that is gone makes no crew`() {
        val first = tested.node()
        val fleet = tested.leader()
        await(fleet, 1)
        val late = tested.node()
        val nodes = await(fleet, 2)
        assertEquals(listOf("${first.address}", "${late.address}"), nodes.map { it.name })
        late.close()
        await(fleet, 1)
        val mail = fleet.form(nodes)
        assertTrue(mail.isClosed)
        val e = assertThrows(MailClosedException::class.java) { mail.send(0, ByteBuffer.allocate(1)) }
        assertEquals("node ${late.address} has left", e.message)
    }

    @Test
    fun `what a node throws closes the leader's mail in its words, and the node works again`() {
        val crews = AtomicInteger()
        val node = tested.node({ mail, threads ->
            check(crews.incrementAndGet() > 1) { "the first is none" }
            Echo.work(mail, threads)
        })
        val fleet = tested.leader()
        val mail = fleet.form(await(fleet, 1))
        val e = assertThrows(MailClosedException::class.java) { mail.receive(0) }
        assertEquals("node ${node.address}: IllegalStateException: the first is none", e.message)
        Echo.around(fleet.form(await(fleet, 1)), ByteArray(5))
    }

    @Test
    fun `a node that takes nothing lets little in, and then all`() {
        val go = CountDownLatch(1)
        val taken = AtomicReference<CrewMail>()
        tested.node({ mail, _ ->
            taken.set(mail as CrewMail)
            go.await()
            repeat(MANY) { mail.receive(Mail.LEADER) }
            mail.send(Mail.LEADER, ByteBuffer.allocate(1))
            mail.receive(Mail.LEADER)
        })
        val fleet = tested.leader()
        val mail = fleet.form(await(fleet, 1))
        val body = ByteBuffer.wrap(ByteArray(4 shl 20))
        repeat(MANY) { mail.send(0, body.duplicate()) }
        awaitThat("full node") { taken.get()?.let { it.load().second > 32 shl 20 } == true }
        awaitThat("standstill") { (mail as CrewMail).load().first == 0L }
        val (_, waiting) = taken.get().load()
        assertTrue(waiting <= 40 shl 20) { "$waiting bytes wait" }
        go.countDown()
        assertEquals(1, mail.receive(0).remaining())
    }

    @Test
    fun `a mail that one member closes closes for all`() {
        val ended = CountDownLatch(2)
        val work = NodeWork { mail, _ ->
            try {
                mail.send(Mail.LEADER, ByteBuffer.allocate(1))
                if (mail.rank == 1 && mail.receive(Mail.LEADER).remaining() == 1) mail.close()
                mail.receive(Mail.LEADER)
            } catch (_: MailClosedException) {
                ended.countDown()
            }
        }
        repeat(2) { tested.node(work) }
        val fleet = tested.leader()
        val mail = fleet.form(await(fleet, 2))
        // A node whose crew ends before its work has begun does not begin.
        for (rank in 0..1) mail.receive(rank)
        mail.send(1, ByteBuffer.allocate(1))
        assertThrows(MailClosedException::class.java) { mail.receive(0) }
        ended.await()
    }

    @Test
    fun `the end of the leader's mail or of its fleet reaches the nodes`() {
        val reasons = LinkedBlockingQueue<String>()
        tested.node({ mail, _ ->
            mail.send(Mail.LEADER, ByteBuffer.allocate(1))
            reasons += assertThrows(MailClosedException::class.java) { mail.receive(Mail.LEADER) }.message!!
        })
        val fleet = tested.leader("one")
        fleet.form(await(fleet, 1)).use { it.receive(0) }
        assertEquals("the leader has ended the crew", reasons.take())
        fleet.form(await(fleet, 1)).receive(0)
        fleet.close()
        // The farewell, the end of the crew and the departure of the leader come on ways of their own.
        val gone = "the leader ${fleet.address} "
        val reason = reasons.take()
        assertTrue(reason in setOf("the leader has ended the crew", "run one has ended") || reason.startsWith(gone))
        awaitThat("line") {
            tested.lines.any { it == "run one has ended; waiting for a run" || it.startsWith(gone) }
        }
        assertThrows(FleetException::class.java) { fleet.nodes() }
    }

    @Test
    fun `nodes work for one leader at a time`() {
        tested.node()
        val first = tested.leader("first")
        val mail = first.form(await(first, 1))
        val second = tested.leader("second")
        var busy = emptyList<BusyNode>()
        awaitThat("busy node") { second.busy().also { busy = it }.isNotEmpty() }
        assertEquals("first of ${first.address}", busy.single().run)
        assertEquals(0, second.nodes().size)
        Echo.around(mail, ByteArray(3))
        first.close()
        Echo.around(second.form(await(second, 1)), ByteArray(3))
    }

    @Test
    fun `a leader whose nodes have all died joins those that were started in their place`() {
        val first = nodeWithPort()
        val fleet = tested.leader()
        val address = fleet.address
        val mail = fleet.form(await(fleet, 1))
        first.close()
        assertThrows(MailClosedException::class.java) { mail.receive(0) }
        await(fleet, 0)
        // It is the first of its list, and nobody answers: it begins a cluster.
        val settings = tested.settings(listOf(first.address)).copy(port = first.address.port)
        val anew = tested.node(settings = settings)
        assertEquals(first.address, anew.address)
        Echo.around(fleet.form(await(fleet, 1)), ByteArray(3))
        assertEquals(address, fleet.address)
        val found = "there is no node here, but one at ${first.address}; joining again"
        assertTrue(found in tested.lines || ANEW in tested.lines) { "${tested.lines}" }
        val late = tested.node(settings = tested.settings(listOf(fleet.address)))
        assertEquals("${late.address}", await(fleet, 2)[1].name)
    }

    @Test
    fun `a node that may begin no cluster finds the leader whose nodes have all died`() {
        val first = nodeWithPort()
        val second = nodeWithPort()
        val list = listOf(first.address, second.address)
        val fleet = tested.leader(settings = tested.settings(list))
        await(fleet, 2)
        first.close()
        second.close()
        await(fleet, 0)
        val anew = tested.node(settings = tested.settings(list).copy(port = second.address.port))
        assertEquals("${anew.address}", await(fleet, 1).single().name)
        assertFalse(tested.lines.any { "joining again" in it })
        Echo.around(fleet.form(await(fleet, 1)), ByteArray(3))
    }

    @Test
    fun `a fleet that is closed while it comes back ends`() {
        val first = nodeWithPort()
        val fleet = tested.leader()
        await(fleet, 1)
        first.close()
        await(fleet, 0)
        val anew = tested.node(settings = tested.settings(listOf(first.address)).copy(port = first.address.port))
        val closing = Thread {
            awaitThat("coming back") { tested.lines.any { "joining again" in it || it == ANEW } }
            fleet.close()
        }.apply { start() }
        assertThrows(FleetException::class.java) { while (true) fleet.nodes() }
        closing.join()
        anew.close()
        assertThrows(FleetException::class.java) { fleet.nodes() }
        assertThrows(FleetException::class.java) { fleet.busy() }
    }

    /** A node at whose port another can be started when it is gone. */
    private fun nodeWithPort() = tested.node(settings = tested.settings().copy(port = FreePorts.one()))

    private companion object {
        /** What a leader says instead of where a node is, when the node took too long to start. */
        const val ANEW = "no node is left; looking for nodes anew"

        /** Messages of 4 MiB. */
        const val MANY = 40
    }
}
