package daphnis.app

import daphnis.core.cluster.BusyNode
import daphnis.core.cluster.Fleet
import daphnis.core.cluster.FleetException
import daphnis.core.cluster.FleetNode
import daphnis.core.cluster.Mail

/** A fleet that [start] makes when it is first asked for something. */
internal class LateFleet(private val start: () -> Fleet) : Fleet {
    private var fleet: Fleet? = null
    private var isClosed = false

    /** Who starts the fleet. */
    @Volatile
    private var starter: Thread? = null

    @Volatile
    private var isGivenUp = false

    /** When nodes began to work together; null while they are waited for. */
    @Volatile
    private var formedAt: Long? = null

    /** Nanoseconds since then; 0 while nodes are waited for. */
    val able: Long get() = formedAt?.let { System.nanoTime() - it } ?: 0

    override fun nodes(): List<FleetNode> = started().nodes()

    /** Asked by those alone who wait for nodes. */
    override fun busy(): List<BusyNode> {
        formedAt = null
        if (isGivenUp) throw FleetException(GIVEN_UP)
        return started().busy()
    }

    override fun form(nodes: List<FleetNode>): Mail = started().form(nodes).also { formedAt = System.nanoTime() }

    /** Ends every wait for nodes with a [FleetException]; a run that has its nodes goes on. Any thread may call. */
    fun giveUp() {
        isGivenUp = true
        starter?.interrupt()
    }

    @Synchronized
    private fun started(): Fleet {
        check(!isClosed) { "the fleet is closed" }
        fleet?.let { return it }
        starter = Thread.currentThread()
        try {
            if (isGivenUp) throw FleetException(GIVEN_UP)
            return start().also { fleet = it }
        } catch (e: InterruptedException) {
            throw FleetException(GIVEN_UP)
        } finally {
            starter = null
        }
    }

    @Synchronized
    override fun close() {
        isClosed = true
        fleet?.close()
    }

    private companion object {
        const val GIVEN_UP = "interrupted while it waited for nodes"
    }
}
