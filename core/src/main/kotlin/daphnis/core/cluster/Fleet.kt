package daphnis.core.cluster

import daphnis.core.input.oneLine

/**
 * The nodes that can work for a run, as its leader sees them. Nodes come and go at any time. Any thread may call.
 */
public interface Fleet : AutoCloseable {
    /** The nodes that can work now, in an order that stays: those that came first are first. */
    public fun nodes(): List<FleetNode>

    /** The nodes that are there too, but work for another run. */
    public fun busy(): List<BusyNode> = emptyList()

    /**
     * Makes a crew of [nodes], in this order by rank; the crew before ends. Each begins its work ([NodeWork]) as soon
     * as it has ended what it did before.
     *
     * @return the leader's mail, which closes when one of the nodes is lost, or works for another run by now
     * @throws FleetException when nodes cannot be asked
     */
    public fun form(nodes: List<FleetNode>): Mail

    /** Leaves the nodes, which wait for other runs. */
    override fun close()
}

/**
 * A node of a [Fleet]. Two are the same if they are the same process.
 *
 * @property name for messages, such as `host:port`
 * @property threads how many it works with
 * @property incarnation distinguishes processes that had the same [name] one after the other
 */
public data class FleetNode(val name: String, val threads: Int, val incarnation: Long)

/**
 * A node that works for another run.
 *
 * @property name as in [FleetNode]
 * @property run its name, and where its process is: `ring-patch of host:port`
 */
public data class BusyNode(val name: String, val run: String)

/** What a node does in a crew, on a thread of its own, until this returns or throws. */
public fun interface NodeWork {
    /**
     * @param mail of the node in this crew; its end is told by a [MailClosedException]
     * @param threads how many the node may work with
     */
    public fun work(mail: Mail, threads: Int)
}

/** Nodes cannot be had; the message is one line for the user. */
public class FleetException @JvmOverloads constructor(message: String, cause: Throwable? = null) :
    RuntimeException(oneLine(message), cause)
