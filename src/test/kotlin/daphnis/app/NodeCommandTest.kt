package daphnis.app

import daphnis.cluster.LocalNodes
import daphnis.core.cluster.FleetEngines
import daphnis.core.cluster.FleetException
import daphnis.core.run.Run
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.net.InetAddress
import java.net.ServerSocket
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.TimeUnit

@Tag("jdk-neutral")
@Timeout(300)
class NodeCommandTest {
    @TempDir
    lateinit var folder: Path

    private val lines = ConcurrentLinkedQueue<String>()

    private fun start(count: Int, vararg words: String) = LocalNodes.start(count, "test", { address ->
        LocalNodes.java("daphnis.app.MainKt") +
            listOf("node", "--join", "$address", "--until-input-ends", "--threads", "1") + words
    }, lines::add, within = Duration.ofSeconds(120))

    @Tag("thorough")
    @Test
    fun `nodes that another process has started join, print no news, and end with their input`() {
        val nodes = start(2)
        val children = nodes.pids.map { ProcessHandle.of(it).get() }
        // One that is slow to answer is hidden for a moment.
        assertTrue(generateSequence { nodes.fleet.nodes().map { it.threads } }.any { it == listOf(1, 1) })
        nodes.close()
        assertTrue(children.none { it.isAlive })
        assertEquals(emptyList<String>(), lines.toList())
    }

    @Test
    fun `a run over two processes gives the same bits as one engine alone`() {
        val alone = "${folder.resolve("alone")}"
        assertDone(daphnis("run", "cooling-gas", "--until", "1", "--engine", "serial", "--out", alone, "--quiet"))
        val scenario = scenarioNamed("cooling-gas", listOf("until=1"))
        start(2).use { nodes ->
            val engines = FleetEngines(nodes.fleet)
            Run.start(scenario, "cooling-gas", folder.resolve("nodes"), engines = engines).use { it.execute() }
        }
        assertDone(daphnis("compare", alone, "${folder.resolve("nodes")}"))
    }

    @Tag("thorough")
    @Test
    fun `a node whose parent has gone while it joins ends too`() {
        // Nobody listens on port 1.
        val words = listOf("node", "--join", "127.0.0.1:1", "--join-within", "600", "--until-input-ends")
        val node = ProcessBuilder(LocalNodes.java("daphnis.app.MainKt") + words)
            .redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start()
        try {
            node.outputStream.close()
            assertTrue(node.waitFor(150, TimeUnit.SECONDS)) { "it goes on joining for 600 s" }
        } finally {
            node.destroyForcibly()
        }
    }

    @Tag("thorough")
    @Test
    fun `a node that cannot listen ends with its reason`() {
        ServerSocket(0, 1, InetAddress.getByName("127.0.0.1")).use { taken ->
            val e = assertThrows(FleetException::class.java) { start(1, "--port", "${taken.localPort}") }
            val said = "has ended with code 1: daphnis: port ${taken.localPort} of 127.0.0.1 is in use"
            assertTrue(said in e.message!!) { e.message }
        }
    }

    @Test
    fun `wrong words are told in one line`() {
        assertRefused(daphnis("node", "--join", "n1"), "--join", "n1", "a port is needed")
        assertRefused(daphnis("node", "--port", "70000"), "--port", "70000", "0..65535")
        assertRefused(daphnis("node", "--threads", "0"), "--threads", "0")
        assertRefused(daphnis("node", "--host", "0.0.0.0"), "--host", "no TLS", "add --insecure where")
        assertRefused(daphnis("node", "--bind", "0.0.0.0"), "--bind", "no TLS")
        assertRefused(daphnis("node", "--host", "0.0.0.0", "--insecure"), "--host", "a secret is needed")
        assertRefused(daphnis("node", "--host", "no.such.host.invalid"), "--host", "no.such.host.invalid")
        assertRefused(daphnis("node", "--join-within", "-1"), "--join-within")
        assertRefused(daphnis("node", "--secret-file", "${folder.resolve("none")}"), "none", "cannot be read")
        assertRefused(daphnis("node", "--config", "${folder.resolve("none")}"), "none", "cannot be read")
        val short = Files.writeString(folder.resolve("short"), "abc")
        assertRefused(daphnis("node", "--secret-file", "$short"), "$short", "at least 16")
        val broken = Files.writeString(folder.resolve("broken.conf"), "daphnis { ")
        assertRefused(daphnis("node", "--config", "$broken"), "broken.conf")
        val wrong = Files.writeString(folder.resolve("wrong.conf"), "daphnis.cluster.chunk = 0")
        assertRefused(daphnis("node", "--config", "$wrong"), "wrong.conf", "chunk")
        val tls = Files.writeString(folder.resolve("tls.conf"), "daphnis.cluster.tls.key = /no/such/key")
        assertFalse("Exception" in daphnis("node", "--config", "$tls").err)
        assertRefused(daphnis("node", "--config", "$tls"), "tls.conf", "daphnis.cluster.tls")
    }
}
