package daphnis.cluster.wire

import daphnis.cluster.hosts.HostPort

/**
 * A process of the cluster.
 *
 * @property address where it is reached
 * @property incarnation distinguishes processes that had the same [address] one after the other
 */
internal data class Peer(val address: HostPort, val incarnation: Long)

/**
 * What processes of a cluster write to each other beside the links. Each may be lost, and each may come twice.
 *
 * ```
 *   caller                    answerer
 *     Hello  ----------------->          protocol, version, random number
 *     <----------------- Challenge       random number, proof        (or Refusal)
 *     Proof  ----------------->          proof
 *     <------------------- Welcome       they have a session          (or Refusal)
 *
 *   leader                    node
 *     Order  ----------------->          what the crew is to do, again each second
 *     <------------------ Standing       how far it is, also unasked
 *     Farewell --------------->          the run is over
 * ```
 */
internal sealed interface Note {
    val from: Peer

    /** Begins a handshake. The first fields stay the same in all versions. */
    class Hello(override val from: Peer, val protocol: Int, val version: String, val nonce: ByteArray) : Note

    /** Proves the answerer's knowledge of the secret, for the greeting with the number [hello]. */
    class Challenge(override val from: Peer, val hello: ByteArray, val nonce: ByteArray, val proof: ByteArray) : Note

    /** Proves the caller's knowledge of the secret; says whether the caller is in a cluster. */
    class Proof(override val from: Peer, val hello: ByteArray, val proof: ByteArray, val isMember: Boolean) : Note

    /** Ends a handshake; the answerer works with [threads], and may be asked to let in others if it [isMember]. */
    class Welcome(override val from: Peer, val hello: ByteArray, val threads: Int, val isMember: Boolean) : Note

    /** Ends a handshake that failed. */
    class Refusal(override val from: Peer, val hello: ByteArray, val reason: String) : Note

    /**
     * What a leader wants of a node.
     *
     * @property session that the two have
     * @property number of the crew; greater ones follow
     * @property key of the crew on its links
     * @property rank of the node
     * @property run name of the run
     * @property members by rank
     */
    class Order(
        override val from: Peer,
        val session: Long,
        val number: Long,
        val key: Long,
        val phase: Phase,
        val rank: Int,
        val run: String,
        val members: List<Peer>,
    ) : Note

    /** How far a node is with the crew of [key]. */
    class Standing(override val from: Peer, val session: Long, val key: Long, val state: State, val words: String) :
        Note

    /** The leader needs the node no more. */
    class Farewell(override val from: Peer, val session: Long) : Note

    /** What the crew is to do. */
    enum class Phase {
        /** End what was before, and take mail. */
        PREPARE,

        /** All take mail: work. */
        BEGIN,

        /** The crew has ended. */
        END,

        /** There is no crew: the leader wants to know whether the node works for another run. */
        ASK,
    }

    /** How far a node is. */
    enum class State {
        /** Takes the mail of the crew. */
        READY,

        /** The work is under way, or has returned. */
        WORKING,

        /** The node has closed its mail, or its work has failed: the words say why. */
        ENDED,

        /** It belongs to another run, which the words name. */
        BUSY,

        /** There is no such session. */
        STRANGER,

        /** It works for no other run. */
        FREE,
    }
}
