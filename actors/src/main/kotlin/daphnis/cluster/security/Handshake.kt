package daphnis.cluster.security

import java.nio.ByteBuffer

/**
 * Two processes prove to each other that they know the secret, and that they talk of the same: the one that calls, with
 * the random number [callersNonce], and the one that answers, with [answerersNonce]. What each proves holds both
 * numbers, both names and its side, so that no proof serves twice, for another, or sent back to its maker.
 */
internal class Handshake(
    private val secret: Secret,
    private val caller: String,
    private val callersNonce: ByteArray,
    private val answerer: String,
    private val answerersNonce: ByteArray,
) {
    /** What the answerer proves. */
    val answerersProof: ByteArray get() = proof("answer")

    /** What the caller proves. */
    val callersProof: ByteArray get() = proof("call")

    /** A number that only the two know, which stands for what they agreed. */
    val session: Long get() = ByteBuffer.wrap(proof("session")).getLong()

    private fun proof(side: String) = secret.proof(
        side.toByteArray(),
        caller.toByteArray(),
        callersNonce,
        answerer.toByteArray(),
        answerersNonce,
    )
}
