package daphnis.cluster

import daphnis.cluster.TestedFleet.Companion.await
import daphnis.cluster.TestedFleet.Companion.awaitThat
import daphnis.cluster.local.ChildProcess
import daphnis.core.cluster.FleetException
import daphnis.core.cluster.MailClosedException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.ConcurrentLinkedQueue

/** Nodes in JVMs of their own, and signals. */
@Tag("jdk-neutral")
@Timeout(300)
@Tag("thorough")
class LocalNodesTest {
    @TempDir
    lateinit var folder: Path

    private val lines = ConcurrentLinkedQueue<String>()

    private fun config(text: String) = Files.writeString(folder.resolve("daphnis.conf"), text)

    private fun start(count: Int, config: Path) = LocalNodes.start(
        count,
        "local",
        { LocalNodes.java("daphnis.cluster.TestNode").filter { "jdwp" !in it } + listOf("$it", "$config") },
        lines::add,
        config,
        Duration.ofSeconds(120),
    )

    private fun signal(name: String, pid: Long) =
        assertEquals(0, ProcessBuilder("kill", "-$name", "$pid").start().waitFor())

    @Test
    fun `a killed process closes the mail, and the others go on`() {
        start(2, TestedFleet.quick(folder)).use { nodes ->
            val mail = nodes.fleet.form(await(nodes.fleet, 2))
            Echo.around(mail, ByteArray(1_000_000) { it.toByte() })
            signal("KILL", nodes.pids[0])
            val e = assertThrows(MailClosedException::class.java) { mail.receive(0) }
            assertTrue(Regex("(node .*: )?node 127.0.0.1:\\d+ was lost").matches(e.message!!)) { e.message }
            Echo.around(nodes.fleet.form(await(nodes.fleet, 1)), ByteArray(7))
        }
    }

    @Test
    fun `a process that was stopped for a while goes on in its crew`() {
        val config = config("daphnis.cluster { heartbeat = 200 ms, acceptable-pause = 30 s }")
        start(1, config).use { nodes ->
            val mail = nodes.fleet.form(await(nodes.fleet, 1))
            Echo.around(mail, ByteArray(7))
            signal("STOP", nodes.pids[0])
            Thread.sleep(3000)
            signal("CONT", nodes.pids[0])
            Echo.around(mail, ByteArray(7))
            assertFalse(mail.isClosed)
        }
    }

    @Test
    fun `a process that was stopped for too long is lost, and ends with one line`() {
        start(2, TestedFleet.quick(folder)).use { nodes ->
            val mail = nodes.fleet.form(await(nodes.fleet, 2))
            val child = ProcessHandle.of(nodes.pids[1]).get()
            signal("STOP", nodes.pids[1])
            assertThrows(MailClosedException::class.java) { mail.receive(1) }
            await(nodes.fleet, 1)
            signal("CONT", nodes.pids[1])
            awaitThat("end of the process") { !child.isAlive }
            // What a process has printed is read by a thread of its own, perhaps after the end of the process.
            val cut = "process ${nodes.pids[1]}: daphnis: this process was cut off from the others"
            awaitThat("last line of the process") { lines.any { it.startsWith(cut) } }
            val said = lines.filter { it.startsWith("process ${nodes.pids[1]}: ") }
            assertTrue(said.last().startsWith(cut)) { "$said" }
            assertTrue(said.none { "has left" in it }) { "$said" }
        }
    }

    @Test
    fun `a leader that loses most of the cluster at once goes on with the rest, or with none`() {
        start(3, TestedFleet.quick(folder)).use { nodes ->
            val mail = nodes.fleet.form(await(nodes.fleet, 3))
            for (pid in nodes.pids.take(2)) signal("KILL", pid)
            assertThrows(MailClosedException::class.java) { mail.receive(1) }
            Echo.around(nodes.fleet.form(await(nodes.fleet, 1)), ByteArray(7))
            signal("KILL", nodes.pids[2])
            await(nodes.fleet, 0)
        }
    }

    @Test
    fun `a leader that was stopped for too long joins its nodes again`() {
        TestedFleet(folder).use { tested ->
            val node = tested.node()
            val command = LocalNodes.java("daphnis.cluster.TestLeader").filter { "jdwp" !in it } +
                listOf("${node.address}", "${TestedFleet.quick(folder)}")
            val leader = ChildProcess(command, TestedFleet.SECRET, lines::add)
            try {
                awaitThat("first crew") { lines.any { it.endsWith(": around") } }
                signal("STOP", leader.pid)
                awaitThat("loss of the leader") { tested.lines.any { "was lost; waiting for a run" in it } }
                signal("CONT", leader.pid)
                // It hears that it was given up, or first gives up the node, which cannot answer it any more.
                val back = Regex(
                    ".*: (this process was cut off from the nodes, or stopped for too long; joining again" +
                        "|no node is left; looking for nodes anew)",
                )
                awaitThat("another crew after it has come back") {
                    lines.dropWhile { !back.matches(it) }.any { it.endsWith(": around") }
                }
            } finally {
                signal("KILL", leader.pid)
                leader.end()
            }
        }
    }

    @Test
    fun `a process that does not come is told with its last line`() {
        val e = assertThrows(FleetException::class.java) {
            LocalNodes.start(2, "local", { LocalNodes.java("daphnis.NoSuchClass") }, lines::add)
        }
        assertTrue("has ended with code 1: " in e.message!! && "NoSuchClass" in e.message!!) { e.message }
        assertThrows(FleetException::class.java) { LocalNodes.start(1, "x", { listOf("/no/such/java") }, lines::add) }
    }

    @Test
    fun `nodes end with their parent`() {
        val nodes = start(1, TestedFleet.quick(folder))
        val child = ProcessHandle.of(nodes.pids.single()).get()
        nodes.close()
        assertFalse(child.isAlive)
        assertTrue(lines.any { "is waiting for a run" in it })
    }
}
