package daphnis.cluster.wire

import daphnis.cluster.hosts.HostPort
import daphnis.cluster.link.Chunk
import daphnis.cluster.link.Probe
import daphnis.cluster.link.Receipt
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.io.NotSerializableException
import java.nio.ByteBuffer
import kotlin.random.Random

class FrameSerializerTest {
    private val serializer = FrameSerializer()
    private val peer = Peer(HostPort("fe80::1", 25520), -7)

    private fun chunk(): Chunk {
        val bytes = ByteBuffer.wrap(byteArrayOf(1, 2, 3))
        return Chunk(9, -1, 2, 5, 30, 10, bytes, Chunk.checkOf(9, -1, 2, 5, 30, 10, bytes))
    }

    private val all: List<Any> = listOf(
        chunk(),
        Receipt(9, 2, -1, 5, 1L shl 40),
        Probe(9, -1, 2),
        Note.Hello(peer, 3, "1.2", byteArrayOf(4)),
        Note.Challenge(peer, byteArrayOf(1), byteArrayOf(2, 2), byteArrayOf()),
        Note.Proof(peer, byteArrayOf(1), byteArrayOf(3), true),
        Note.Welcome(peer, byteArrayOf(1), 16, true),
        Note.Refusal(peer, byteArrayOf(1), "wrong"),
        Note.Order(peer, 1, 2, 3, Note.Phase.BEGIN, 1, "ring", listOf(peer, Peer(HostPort("n", 1), 2))),
        Note.Standing(peer, 1, 2, Note.State.BUSY, "ö"),
        Note.Farewell(peer, 1),
    )

    @Test
    fun `all that is sent comes out again`() {
        for (one in all) {
            val bytes = serializer.toBinary(one)
            val back = serializer.fromBinary(bytes, serializer.manifest(one))
            assertEquals(one.javaClass, back.javaClass)
            assertArrayEquals(bytes, serializer.toBinary(back))
        }
        val back = serializer.fromBinary(serializer.toBinary(chunk()), "L") as Chunk
        assertTrue(back.isWhole)
        val order = serializer.fromBinary(serializer.toBinary(all[8]), "N") as Note.Order
        assertEquals(listOf(peer, Peer(HostPort("n", 1), 2)), order.members)
    }

    @Test
    fun `names in the note of a stranger are short and plain, or the note is none`() {
        fun isRead(host: String, version: String = "0.1.0-SNAPSHOT", port: Int = 1): Boolean = try {
            val note = Note.Hello(Peer(HostPort(host, port), 1), 999, version, ByteArray(32))
            serializer.fromBinary(serializer.toBinary(note), "N") is Note.Hello
        } catch (_: NotSerializableException) {
            false
        }
        for (host in listOf("n", "login.cluster_2", "10.0.0.7", "::1", "fe80::1%eth0", "n".repeat(255))) {
            assertTrue(isRead(host)) { host }
        }
        val obeyed =
            listOf("\n", "\r", "\u001b[2J", "\u0007", "\u007f", "\u009b", "\u2028", "\u2029", "\u202e", "\u2066", " ")
        for (host in obeyed.map { "evil${it}host" } + listOf("", "n".repeat(256))) assertFalse(isRead(host)) { host }
        for (version in obeyed.map { "9.9${it}RED" } + listOf("", "1".repeat(65))) assertFalse(isRead("n", version))
        for (port in listOf(-1, 0, 65536)) assertFalse(isRead("n", port = port)) { "$port" }
    }

    @Test
    fun `frames that are cut short or damaged take no memory and throw only what Pekko expects`() {
        val random = Random(5)
        for (one in all) {
            val bytes = serializer.toBinary(one)
            val manifest = serializer.manifest(one)
            for (length in bytes.indices) {
                assertThrows(NotSerializableException::class.java) {
                    serializer.fromBinary(bytes.copyOf(length), manifest)
                }
            }
            repeat(2000) {
                val damaged = bytes.clone()
                repeat(1 + random.nextInt(3)) { damaged[random.nextInt(bytes.size)] = random.nextInt().toByte() }
                try {
                    serializer.fromBinary(damaged, manifest)
                } catch (_: NotSerializableException) {
                    // As it should be.
                }
            }
        }
    }

    @Test
    fun `a long text is cut and what is none of daphnis's is refused`() {
        val note = Note.Standing(peer, 1, 2, Note.State.ENDED, "x".repeat(100_000))
        val back = serializer.fromBinary(serializer.toBinary(note), "N") as Note.Standing
        assertEquals(1000, back.words.length)
        assertThrows(NotSerializableException::class.java) { serializer.manifest("text") }
        assertThrows(NotSerializableException::class.java) { serializer.fromBinary(ByteArray(10), "X") }
    }
}
