package daphnis.cluster.security

import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class SecretTest {
    @TempDir
    lateinit var folder: Path

    private val secret = Secret.of("0123456789abcdef", "test")

    @Test
    fun `a file's secret is what stands in it without spaces around`() {
        val file = Files.writeString(folder.resolve("s"), " 0123456789abcdef\n")
        assertArrayEquals(secret.proof(byteArrayOf(1)), Secret.read(file).proof(byteArrayOf(1)))
    }

    @Test
    fun `short, long and missing secrets are refused by name, and never shown`() {
        assertThrows(InputException::class.java) { Secret.of("0123456789abcde", "test") }
        val long = Files.writeString(folder.resolve("long"), "x".repeat(5000))
        val e = assertThrows(InputException::class.java) { Secret.read(long) }
        assertTrue("$long" in e.message!!)
        assertThrows(InputException::class.java) { Secret.read(folder.resolve("none")) }
        assertEquals("a secret", "$secret")
        assertFalse(secret.isNone)
        assertTrue(Secret.NONE.isNone)
    }

    @Test
    fun `parts of a proof do not run into one another`() {
        val one = secret.proof("ab".toByteArray(), "c".toByteArray())
        val other = secret.proof("a".toByteArray(), "bc".toByteArray())
        assertFalse(one.contentEquals(other))
    }

    @Test
    fun `a handshake proves one thing for each side, name, number and secret`() {
        val a = byteArrayOf(1)
        val b = byteArrayOf(2)
        val one = Handshake(secret, "x", a, "y", b)
        val others = listOf(
            Handshake(Secret.random(), "x", a, "y", b),
            Handshake(secret, "z", a, "y", b),
            Handshake(secret, "x", b, "y", b),
            Handshake(secret, "x", a, "z", b),
            Handshake(secret, "x", a, "y", a),
        )
        assertArrayEquals(one.callersProof, Handshake(secret, "x", a, "y", b).callersProof)
        assertFalse(one.callersProof.contentEquals(one.answerersProof))
        for (other in others) {
            assertFalse(one.callersProof.contentEquals(other.callersProof))
            assertFalse(one.answerersProof.contentEquals(other.answerersProof))
            assertNotEquals(one.session, other.session)
        }
    }
}
