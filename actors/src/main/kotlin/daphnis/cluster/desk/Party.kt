package daphnis.cluster.desk

import daphnis.cluster.wire.Note
import daphnis.cluster.wire.Peer

/** What a process does in the cluster: a node's part, or the leader's. Only the desk calls, on one thread. */
internal interface Party {
    /** A process that works as a node has joined; nodes are told in the order in which they joined. */
    fun joined(node: Peer)

    /** A process has left, or was given up; [why] says which. */
    fun gone(peer: Peer, why: String)

    /** Takes an order, a standing or a farewell. */
    fun take(note: Note)

    /** Some tenths of a second have passed. */
    fun tick()

    /** This process is no longer part of the cluster. */
    fun end(why: String)
}
