package daphnis.cluster

import daphnis.cluster.TestedFleet.Companion.await
import daphnis.cluster.TestedFleet.Companion.awaitThat
import daphnis.cluster.desk.Greeter
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.security.Secret
import daphnis.core.FreePorts
import daphnis.core.cluster.FleetException
import daphnis.core.run.Version
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.net.InetAddress
import java.net.ServerSocket
import java.nio.file.Path
import java.time.Duration

/** Who cannot join, and what the user reads on both sides. */
@Timeout(300)
class RefusalsTest {
    @TempDir
    lateinit var folder: Path

    private val tested by lazy { TestedFleet(folder) }

    @AfterEach
    fun close() = tested.close()

    private fun refusal(join: () -> Unit): String = assertThrows(FleetException::class.java) { join() }.message!!

    @Test
    fun `another secret, or none, is refused on both sides`() {
        val node = tested.node()
        for (secret in listOf(Secret.NONE, Secret.random())) {
            tested.lines.clear()
            val settings = tested.settings().copy(secret = secret)
            val message = refusal { tested.leader("x", settings) }
            assertTrue("were not given the same secret" in message && "${node.address}" in message) { message }
            awaitThat("line of the node") {
                tested.lines.any { Regex("refused 127.*: .* were not given the same secret").matches(it) }
            }
            assertTrue("were not given the same secret" in refusal { tested.node(settings = settings) })
        }
        val fleet = tested.leader()
        assertEquals(1, await(fleet, 1).size)
    }

    @Tag("thorough")
    @Test
    fun `another version or protocol is refused on both sides`() {
        val node = tested.node()
        for (build in listOf(Greeter.Build("0.0.9", 1), Greeter.Build(Version.text, 99))) {
            val message = refusal { tested.leader("x", build = build) }
            assertTrue("is $build, ${node.address} is daphnis" in message) { message }
            awaitThat("line of the node") { tested.lines.any { it.startsWith("refused 127") && "$build" in it } }
        }
    }

    @Tag("thorough")
    @Test
    fun `a port in use, an address of another machine and silence are told in one line`() {
        ServerSocket(0, 1, InetAddress.getByName("127.0.0.1")).use { taken ->
            val settings = tested.settings(listOf()).copy(port = taken.localPort)
            val message = refusal { tested.node(settings = settings) }
            assertEquals(
                "port ${taken.localPort} of 127.0.0.1 is in use; name another port, or 0 for any that is free",
                message,
            )
        }
        val free = FreePorts.one()
        val silent = tested.settings(listOf(HostPort("127.0.0.1", free))).copy(joinWithin = Duration.ofSeconds(1))
        val message = refusal { tested.node(settings = silent) }
        assertTrue(Regex("nobody has answered at 127.0.0.1:$free for \\d+ s; .*").matches(message)) { message }
        val foreign = tested.settings(listOf()).copy(host = "192.0.2.1", insecure = true)
        assertTrue("is that an address of this machine?" in refusal { tested.node(settings = foreign) })
    }

    @Tag("thorough")
    @Test
    fun `the first of a list begins a cluster, and the others wait for it`() {
        val ports = List(2) { FreePorts.one() }
        val list = ports.map { HostPort("127.0.0.1", it) }
        val second = Thread { tested.node(settings = tested.settings(list).copy(port = ports[1])) }.apply { start() }
        tested.node(settings = tested.settings(list).copy(port = ports[0]))
        second.join()
        assertEquals(2, await(tested.leader(settings = tested.settings(list)), 2).size)
    }
}
