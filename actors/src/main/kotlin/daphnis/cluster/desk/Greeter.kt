package daphnis.cluster.desk

import daphnis.cluster.hosts.HostPort
import daphnis.cluster.security.Handshake
import daphnis.cluster.security.Secret
import daphnis.cluster.wire.Note
import daphnis.cluster.wire.Peer
import java.nio.ByteBuffer

/**
 * The handshakes of a process, with those it calls and those that call it. What is lost is not sent again: the caller
 * greets anew. Only the desk calls.
 *
 * @param self this process
 * @param build version of the program, and of what it says to others
 * @param threads this process works with
 * @param isMember whether this process is in the cluster
 * @param say takes a line for the user
 */
internal class Greeter(
    private val self: Peer,
    private val build: Build,
    private val secret: Secret,
    private val threads: Int,
    private val courier: Courier,
    private val isMember: () -> Boolean,
    say: (String) -> Unit,
) {
    private val refusals = Refusals(say)

    /** What processes must have in common. */
    data class Build(val version: String, val protocol: Int) {
        override fun toString() = "daphnis $version with protocol $protocol"
    }

    /** How a greeting went. */
    sealed interface Outcome {
        /** Both know the secret; [session] stands for that. */
        class Friend(val peer: Peer, val session: Long, val threads: Int, val isMember: Boolean) : Outcome

        /** The other is none of this cluster's; [reason] names it. */
        class Refused(val reason: String) : Outcome
    }

    private class Call(val to: HostPort, val nonce: ByteArray, val done: (Outcome) -> Unit) {
        var handshake: Handshake? = null
        var theirs = ByteArray(0)
    }

    private class Answer(val peer: Peer, val nonce: ByteArray, val handshake: Handshake)

    /** Calls under way by what was called, and answers under way by the caller's random number. */
    private val calls = HashMap<HostPort, Call>()
    private val answers = object : LinkedHashMap<ByteBuffer, Answer>() {
        override fun removeEldestEntry(eldest: MutableMap.MutableEntry<ByteBuffer, Answer>?) = size > MOST_ANSWERS
    }

    /** Who has called, by session. */
    private val sessions = HashMap<Long, Peer>()

    /** Is told of a member of a cluster that has called and knows the secret. Set before the desk begins. */
    var called: (Peer) -> Unit = {}

    /** Calls [to], instead of an earlier call to it. */
    fun greet(to: HostPort, done: (Outcome) -> Unit) {
        val call = Call(to, Secret.nonce(), done)
        calls[to] = call
        courier.send(to, Note.Hello(self, build.protocol, build.version, call.nonce))
    }

    /** Whether [peer] has shown that it knows the secret, in [session]. */
    fun knows(peer: Peer, session: Long): Boolean = sessions[session] == peer

    /** [peer] is gone for good. */
    fun forget(peer: Peer) {
        sessions.values.removeAll { it == peer }
        calls.remove(peer.address)
    }

    /** Takes a note of a handshake. @return whether [note] is one */
    fun take(note: Note): Boolean {
        when (note) {
            is Note.Hello -> answer(note)
            is Note.Challenge -> prove(note)
            is Note.Proof -> welcome(note)
            is Note.Welcome -> call(note.hello)?.let { call ->
                val session = call.handshake?.session ?: return true
                calls.remove(call.to)
                call.done(Outcome.Friend(note.from, session, note.threads, note.isMember))
            }
            is Note.Refusal -> refused(note)
            else -> return false
        }
        return true
    }

    private fun answer(hello: Note.Hello) {
        val theirs = Build(hello.version, hello.protocol)
        if (theirs != build) {
            val reason = "${hello.from.address} is $theirs, ${self.address} is $build"
            refuse(hello.from, hello.nonce, reason, hasAnswered = false)
            return
        }
        // The same greeting twice is answered in the same words, or its two answers would not fit together.
        val answer = answers.getOrPut(ByteBuffer.wrap(hello.nonce)) {
            val nonce = Secret.nonce()
            Answer(hello.from, nonce, Handshake(secret, name(hello.from), hello.nonce, name(self), nonce))
        }
        if (answer.peer != hello.from) return
        val proof = answer.handshake.answerersProof
        courier.send(hello.from.address, Note.Challenge(self, hello.nonce, answer.nonce, proof))
    }

    private fun prove(challenge: Note.Challenge) {
        val call = call(challenge.hello) ?: return
        if (call.handshake != null && !call.theirs.contentEquals(challenge.nonce)) return
        val peer = challenge.from
        val handshake = Handshake(secret, name(self), call.nonce, name(peer), challenge.nonce)
        if (!Secret.same(handshake.answerersProof, challenge.proof)) {
            calls.remove(call.to)
            // Who has called says it here; the other is told.
            courier.send(peer.address, Note.Refusal(self, call.nonce, otherSecret(self, peer)))
            call.done(Outcome.Refused(otherSecret(self, peer)))
            return
        }
        call.handshake = handshake
        call.theirs = challenge.nonce
        courier.send(peer.address, Note.Proof(self, call.nonce, handshake.callersProof, isMember()))
    }

    private fun welcome(proof: Note.Proof) {
        val answer = answers[ByteBuffer.wrap(proof.hello)]?.takeIf { it.peer == proof.from } ?: return
        answers.remove(ByteBuffer.wrap(proof.hello))
        val peer = answer.peer
        val handshake = answer.handshake
        if (!Secret.same(handshake.callersProof, proof.proof)) {
            refuse(peer, proof.hello, otherSecret(peer, self), hasAnswered = true)
            return
        }
        sessions[handshake.session] = peer
        courier.send(peer.address, Note.Welcome(self, proof.hello, threads, isMember()))
        if (proof.isMember) called(peer)
    }

    private fun refused(refusal: Note.Refusal) {
        val call = call(refusal.hello)
        if (call != null) {
            calls.remove(call.to)
            call.done(Outcome.Refused(refusal.reason))
            return
        }
        // The caller has found the proof of this process wrong: only it can know, and its words are not repeated.
        val peer = answers.remove(ByteBuffer.wrap(refusal.hello))?.peer ?: return
        refusals.refused(peer.address, otherSecret(peer, self), hasAnswered = true, System.nanoTime())
    }

    private fun refuse(peer: Peer, hello: ByteArray, reason: String, hasAnswered: Boolean) {
        refusals.refused(peer.address, reason, hasAnswered, System.nanoTime())
        courier.send(peer.address, Note.Refusal(self, hello, reason))
    }

    /** Called now and then. */
    fun tick() {
        refusals.tick(System.nanoTime())
    }

    private fun call(hello: ByteArray) = calls.values.find { it.nonce.contentEquals(hello) }

    private fun otherSecret(one: Peer, other: Peer) =
        "${one.address} and ${other.address} were not given the same secret"

    private fun name(peer: Peer) = "${peer.address}#${peer.incarnation}"

    private companion object {
        const val MOST_ANSWERS = 1000
    }
}
