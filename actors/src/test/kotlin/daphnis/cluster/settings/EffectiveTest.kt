package daphnis.cluster.settings

import daphnis.cluster.security.Secret
import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class EffectiveTest {
    @TempDir
    lateinit var folder: Path

    private val secret = Secret.of("a secret of the tests", "test")

    private fun file(text: String) = Files.writeString(folder.resolve("x.conf"), text)

    private fun refusal(settings: ClusterSettings): String =
        assertThrows(InputException::class.java) { Effective(settings) }.message!!

    @Test
    fun `without TLS only the loopback address is open, unless that is wanted in so many words and with a secret`() {
        for (host in listOf("127.0.0.1", "localhost", "::1")) Effective(ClusterSettings(host))
        assertTrue("there is no TLS" in refusal(ClusterSettings("192.0.2.1", secret = secret)))
        assertTrue("there is no TLS" in refusal(ClusterSettings(bind = "0.0.0.0", secret = secret)))
        assertTrue("a secret is needed" in refusal(ClusterSettings("192.0.2.1", insecure = true)))
        assertFalse(Effective(ClusterSettings("192.0.2.1", insecure = true, secret = secret)).isTls)
        assertTrue(Effective(ClusterSettings("192.0.2.1", config = file("$TRANSPORT = tls-tcp"))).isTls)
    }

    @Test
    fun `TLS needs all its files`() {
        val here = file("x = 1")
        assertTrue("certificate" in refusal(ClusterSettings(config = file("$TLS { key = \"$here\" }"))))
        val message = refusal(ClusterSettings(config = file("$TLS { key = /no/such, certificate = a, authority = b }")))
        assertTrue("/no/such" in message && "cannot be read" in message) { message }
    }

    @Test
    fun `the user's file comes before the settings that are shipped, and arguments before it`() {
        val text = "daphnis.cluster { chunk = 1 KiB, stable-after = 9 s }\npekko.remote.artery.canonical.port = 5"
        val effective = Effective(ClusterSettings("::1", port = 77, config = file(text)))
        assertEquals(1024, effective.limits.chunk)
        val config = effective.config(listOf("node"))
        assertEquals(9000, config.getDuration("daphnis.cluster.stable-after").toMillis())
        assertEquals(77, config.getInt("pekko.remote.artery.canonical.port"))
        assertEquals("[::1]", config.getString("pekko.remote.artery.canonical.hostname"))
        val local = Effective(ClusterSettings("localhost")).config(listOf("node"))
        assertEquals("127.0.0.1", local.getString("pekko.remote.artery.canonical.hostname"))
        assertEquals(listOf("node"), config.getStringList("pekko.cluster.roles"))
        assertFalse(config.getBoolean("pekko.actor.allow-java-serialization"))
    }

    @Test
    fun `values that cannot be are refused with their key`() {
        for (line in listOf(
            "chunk = 0",
            "window = 1 KiB",
            "longest-message = 3 GiB",
            "chunk = many",
            "stable-after = soon",
        )) {
            val message = refusal(ClusterSettings(config = file("daphnis.cluster.$line")))
            assertTrue("x.conf" in message) { message }
        }
        assertThrows(InputException::class.java) { ClusterSettings(port = -1) }
        assertThrows(InputException::class.java) { ClusterSettings(threads = 0) }
    }

    private companion object {
        const val TRANSPORT = "pekko.remote.artery.transport"
        const val TLS = "daphnis.cluster.tls"
    }
}
