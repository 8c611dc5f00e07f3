package daphnis.actors.region

import daphnis.core.engine.islands.IslandWorkers

/**
 * Islands that cross borders, and the locks under which they are processed. An island needs the regions to which its
 * spheres belong and those around them, since it may grow into these. Islands that need the same regions form a batch.
 * A batch is granted to the first of its regions when all that it needs are unlocked; either all are locked at once or
 * none, so no batch waits while it holds a lock, and there is no lock order to violate. Batches are tried in the order
 * of their first collisions.
 */
internal class BorderIslands(private val map: RegionMap, private val workers: IslandWorkers) {
    private class Batch(val regions: BooleanArray) {
        val islands = ArrayList<Int>()
        var start = Double.POSITIVE_INFINITY
    }

    private val waiting = ArrayList<Batch>()
    private val granted = HashMap<Int, Batch>()
    private val lockedBy = IntArray(map.count) { NOBODY }

    val isEmpty: Boolean get() = waiting.isEmpty() && granted.isEmpty()

    fun clear() {
        waiting.clear()
        granted.clear()
        lockedBy.fill(NOBODY)
    }

    /**
     * Adds the island of [root]. [also] is a sphere that it needs besides those of its seeds, −1 for none; [before] are
     * the regions that it had already.
     */
    fun add(root: Int, also: Int, before: BooleanArray?) {
        val regions = before?.copyOf() ?: BooleanArray(map.count)
        workers.forEachSeeded(root) { lockAround(map.regionOf(it), regions) }
        if (also >= 0) lockAround(map.regionOf(also), regions)
        val batch = waiting.firstOrNull { it.regions.contentEquals(regions) } ?: Batch(regions).also { waiting += it }
        batch.islands += root
        batch.start = minOf(batch.start, workers.startOf(root))
    }

    private fun lockAround(region: Int, regions: BooleanArray) {
        for (other in 0 until map.count) if (map.areNeighbours(region, other)) regions[other] = true
    }

    /** Grants the batches that can be granted now. */
    fun grant(send: (RegionCommand) -> Unit) {
        waiting.sortBy { it.start }
        val iterator = waiting.iterator()
        while (iterator.hasNext()) {
            val batch = iterator.next()
            if (batch.regions.indices.any { batch.regions[it] && lockedBy[it] != NOBODY }) continue
            iterator.remove()
            val leader = batch.regions.indexOf(true)
            for (k in batch.regions.indices) if (batch.regions[k]) lockedBy[k] = leader
            granted[leader] = batch
            send(RegionCommand(leader, Phase.GRANT, batch.islands.toIntArray(), batch.regions))
        }
    }

    /** Unlocks what was granted to the region of [reply], and takes back the islands that it could not process. */
    fun returned(reply: RegionReply) {
        val batch = granted.remove(reply.region) ?: return
        for (k in lockedBy.indices) if (lockedBy[k] == reply.region) lockedBy[k] = NOBODY
        for (k in 0 until reply.border.size / 2) add(reply.border[2 * k], reply.border[2 * k + 1], batch.regions)
    }

    private companion object {
        const val NOBODY = -1
    }
}
