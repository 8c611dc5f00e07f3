package daphnis.cluster.security

import daphnis.core.input.InputException
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.file.Files
import java.nio.file.Path
import java.security.MessageDigest
import java.security.SecureRandom
import javax.crypto.Mac
import javax.crypto.spec.SecretKeySpec

/**
 * What all processes of a cluster know and nobody else. It is never sent: who knows it proves so by a keyed hash of
 * random numbers that the other has drawn.
 */
public class Secret private constructor(private val key: ByteArray) {
    /** Whether it is the [NONE] of processes that were given no secret. */
    public val isNone: Boolean get() = key.contentEquals(NONE.key)

    /** HMAC-SHA-256 of [parts], which cannot run into one another. */
    internal fun proof(vararg parts: ByteArray): ByteArray {
        val mac = Mac.getInstance(ALGORITHM).apply { init(SecretKeySpec(key, ALGORITHM)) }
        for (part in parts) {
            mac.update(ByteBuffer.allocate(Int.SIZE_BYTES).putInt(part.size).array())
            mac.update(part)
        }
        return mac.doFinal()
    }

    /** Says nothing of what it is. */
    override fun toString(): String = if (isNone) "no secret" else "a secret"

    public companion object {
        /** The variable of the environment that may hold a secret. */
        public const val VARIABLE: String = "DAPHNIS_SECRET"

        /** The fewest bytes of a secret. */
        public const val SHORTEST: Int = 16

        /** Length of a random number that is to be proved upon, bytes. */
        internal const val NONCE: Int = 32

        private const val LONGEST = 4096L
        private const val ALGORITHM = "HmacSHA256"
        private val random = SecureRandom()

        /** No secret: any process that has none either is let in. */
        @JvmField
        public val NONE: Secret = Secret("daphnis: no secret".toByteArray())

        /**
         * The secret with the letters of [text], without spaces around it.
         *
         * @param source what holds it, for messages
         * @throws InputException when it is shorter than [SHORTEST] bytes
         */
        @JvmStatic
        public fun of(text: String, source: String): Secret {
            val bytes = text.trim().toByteArray()
            if (bytes.size < SHORTEST) {
                throw InputException(source, null, "a secret of ${bytes.size} bytes; at least $SHORTEST are needed")
            }
            return Secret(bytes)
        }

        /**
         * The secret in the file [path].
         *
         * @throws InputException when it cannot be read, is too short or too long
         */
        @JvmStatic
        public fun read(path: Path): Secret = try {
            val size = Files.size(path)
            if (size > LONGEST) throw InputException("$path", null, "$size bytes are no secret; at most $LONGEST")
            of(String(Files.readAllBytes(path), Charsets.UTF_8), "$path")
        } catch (_: IOException) {
            throw InputException("$path", null, "the secret cannot be read")
        }

        /** A secret that nobody has had. */
        @JvmStatic
        public fun random(): Secret = Secret(nonce().joinToString("") { "%02x".format(it) }.toByteArray())

        /** The secret of the environment, [NONE] without one. */
        @JvmStatic
        public fun ofEnvironment(): Secret = System.getenv(VARIABLE)?.let { of(it, VARIABLE) } ?: NONE

        internal fun nonce() = ByteArray(NONCE).also(random::nextBytes)

        /** Compares in a time that does not tell where [a] and [b] differ. */
        internal fun same(a: ByteArray, b: ByteArray) = MessageDigest.isEqual(a, b)
    }

    /** Its letters, for a child process of this one. */
    internal val text: String get() = String(key, Charsets.UTF_8)
}
