package daphnis.core.cluster.bricks

/** Where the sphere with an id is, for some spheres: an open hash table, which keeps its size from step to step. */
internal class IdIndex {
    private var ids = IntArray(2) { NONE }
    private var places = IntArray(2)
    private var shift = Int.SIZE_BITS - 1

    /** Removes all and makes room for [count]. */
    fun clear(count: Int) {
        val size = Integer.highestOneBit(maxOf(count, 1)) * ROOM
        if (ids.size < size) {
            places = IntArray(size)
            ids = IntArray(size)
        }
        shift = Integer.numberOfLeadingZeros(ids.size) + 1
        ids.fill(NONE)
    }

    fun put(id: Int, place: Int) {
        var k = (id * FACTOR) ushr shift
        while (ids[k] != NONE) k = (k + 1) and (ids.size - 1)
        ids[k] = id
        places[k] = place
    }

    /** The place of [id], or −1. */
    fun find(id: Int): Int {
        var k = (id * FACTOR) ushr shift
        while (ids[k] != NONE) {
            if (ids[k] == id) return places[k]
            k = (k + 1) and (ids.size - 1)
        }
        return NONE
    }

    private companion object {
        const val NONE = -1

        /** Entries for a sphere at least, rounded up to a power of two before: half of the table is empty. */
        const val ROOM = 4
        const val FACTOR = -0x61c88647
    }
}
