package daphnis.cluster

import daphnis.cluster.TestedFleet.Companion.await
import daphnis.core.cluster.FleetException
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.time.Duration

@Timeout(300)
@Tag("thorough")
class TlsTest {
    @TempDir
    lateinit var folder: Path

    private val tested by lazy { TestedFleet(folder) }

    @AfterEach
    fun close() = tested.close()

    @Test
    fun `processes with certificates of the authority work, and no others get in`() {
        val good = Certificates(folder, "good")
        val bad = Certificates(folder, "bad")
        val encrypted = tested.settings().copy(config = good.config(good))
        val node = tested.node(settings = encrypted)
        val fleet = tested.leader(settings = encrypted.copy(join = listOf(node.address)))
        val mail = fleet.form(await(fleet, 1))
        Echo.around(mail, ByteArray(1_000_000) { it.toByte() })
        val within = Duration.ofSeconds(3)
        // One that trusts the others but has no certificate of the authority, and one without TLS.
        for (config in listOf(bad.config(good), TestedFleet.quick(folder))) {
            val settings = encrypted.copy(config = config, join = listOf(node.address), joinWithin = within)
            val e = assertThrows(FleetException::class.java) { tested.leader(settings = settings) }
            assertTrue("nobody has answered at ${node.address}" in e.message!!) { e.message }
        }
        Echo.around(mail, ByteArray(10))
    }
}
