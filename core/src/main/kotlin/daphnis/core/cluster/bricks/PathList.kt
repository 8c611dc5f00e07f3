package daphnis.core.cluster.bricks

import daphnis.core.growth.GrowingTable

/** Ids of spheres and the hashes of their paths, see [PathHash]. The arrays keep their size from step to step. */
internal class PathList : GrowingTable() {
    private var ids = IntArray(0)
    private var hashes = LongArray(0)

    override fun resize(room: Int) {
        ids = ids.copyOf(room)
        hashes = hashes.copyOf(room)
    }

    fun id(k: Int): Int = ids[k]

    fun hash(k: Int): Long = hashes[k]

    fun add(id: Int, hash: Long) {
        val k = append()
        ids[k] = id
        hashes[k] = hash
    }
}
