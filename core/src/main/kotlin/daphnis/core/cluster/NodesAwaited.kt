package daphnis.core.cluster

import java.time.Duration
import java.util.function.Consumer

/**
 * Waits for nodes of [fleet], for [patience] at most; for those that only have to end another run first, without limit.
 *
 * @param log is told, in a line each, what is waited for, whenever that changes
 */
public class NodesAwaited(private val fleet: Fleet, private val patience: Duration, private val log: Consumer<String>) {
    /** Called now and then; may throw to end the wait. */
    internal var check: () -> Unit = {}

    /**
     * The nodes of the fleet, as soon as they are at least [count].
     *
     * @throws FleetException when there are too few for too long
     * @throws InterruptedException when the thread is interrupted
     */
    public fun await(count: Int): List<FleetNode> {
        require(count >= 1) { "count is $count; it must be at least 1" }
        var since = System.nanoTime()
        var told = ""
        while (true) {
            val nodes = fleet.nodes()
            if (nodes.size >= count) return nodes
            val busy = fleet.busy()
            val now = System.nanoTime()
            if (nodes.size + busy.size >= count) since = now
            val line = describe(nodes.size, busy, count)
            if (line != told) log.accept(line)
            told = line
            if (now - since > patience.toNanos()) throw FleetException("${there(nodes.size, count)} come within $limit")
            Thread.sleep(POLL_MILLIS)
            check()
        }
    }

    private val limit: String get() = "${patience.seconds} s"

    private fun there(number: Int, count: Int) = when {
        count == 1 -> "no node has"
        number == 1 -> "1 of $count nodes has"
        else -> "$number of $count nodes have"
    }

    private fun describe(number: Int, busy: List<BusyNode>, count: Int): String {
        val wait = when {
            number + busy.size < count -> "waiting for $limit"
            busy.size == 1 -> "waiting for it"
            else -> "waiting for them"
        }
        val here = when {
            count > 1 && number == 1 -> "1 of $count nodes is there"
            count > 1 -> "$number of $count nodes are there"
            busy.isEmpty() -> "no node is there"
            else -> null
        }
        return "${listOfNotNull(here, occupied(busy)).joinToString(", ")}; $wait"
    }

    private fun occupied(busy: List<BusyNode>): String? {
        if (busy.isEmpty()) return null
        val runs = busy.map { it.run }.distinct().joinToString(" and of ")
        return "${busy.size} ${if (busy.size == 1) "node is" else "nodes are"} busy with the run $runs"
    }

    private companion object {
        const val POLL_MILLIS = 100L
    }
}
