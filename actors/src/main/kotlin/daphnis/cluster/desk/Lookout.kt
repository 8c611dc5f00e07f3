package daphnis.cluster.desk

import daphnis.cluster.desk.Greeter.Outcome
import daphnis.cluster.hosts.HostPort

/**
 * Looks out for nodes on behalf of a leader that has none: it greets the processes that it was told of. When all nodes
 * have died and were started again, some may have begun a cluster of their own, and the leader joins that. Others look
 * for a cluster, and learn by the greeting that the leader is in one.
 *
 * Nodes and a leader that were cut off from each other until both have given up the other cannot talk any more: Pekko
 * never forgets whom it has given up. Only a leader that begins anew can be heard ([mustBeginAnew]).
 *
 * @param others the processes the leader was told of
 */
internal class Lookout(private val others: List<HostPort>, private val greeter: Greeter) {
    private var ticks = 0
    private var seen = 0
    private var hadNodes = false

    /** A process that is in another cluster; null when none was found. */
    @Volatile
    var found: HostPort? = null
        private set

    /** Whether the last node has been gone for some time. */
    @Volatile
    var mustBeginAnew = false
        private set

    fun tick(hasNodes: Boolean) {
        if (hasNodes || others.isEmpty()) {
            hadNodes = hasNodes
            ticks = 0
            seen = 0
            found = null
            mustBeginAnew = false
            return
        }
        ticks++
        if (hadNodes && ticks == GIVEN_UP) mustBeginAnew = true
        if (ticks < PATIENCE || ticks % EACH != 0) return
        val other = others[ticks / EACH % others.size]
        greeter.greet(other) { answered(other, it) }
    }

    /** A node may be new in this cluster, and not yet known to be: one answer proves nothing. */
    private fun answered(other: HostPort, outcome: Outcome) {
        if (ticks < PATIENCE || outcome !is Outcome.Friend || !outcome.isMember) return
        seen++
        if (seen > 1) found = other
    }

    private companion object {
        /** In ticks. */
        const val PATIENCE = 12
        const val EACH = 3

        /** Long enough for a node that was found elsewhere. */
        const val GIVEN_UP = 40
    }
}
