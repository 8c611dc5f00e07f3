package daphnis.app

import daphnis.core.cluster.BusyNode
import daphnis.core.cluster.Fleet
import daphnis.core.cluster.FleetNode
import daphnis.core.cluster.Mail

/** A fleet that [start] makes when it is first asked for something. */
internal class LateFleet(private val start: () -> Fleet) : Fleet {
    private var fleet: Fleet? = null
    private var isClosed = false

    override fun nodes(): List<FleetNode> = started().nodes()

    override fun busy(): List<BusyNode> = started().busy()

    override fun form(nodes: List<FleetNode>): Mail = started().form(nodes)

    @Synchronized
    private fun started(): Fleet {
        check(!isClosed) { "the fleet is closed" }
        return fleet ?: start().also { fleet = it }
    }

    @Synchronized
    override fun close() {
        isClosed = true
        fleet?.close()
    }
}
