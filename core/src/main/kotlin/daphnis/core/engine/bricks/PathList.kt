package daphnis.core.engine.bricks

/** Ids of spheres and the hashes of their paths, see [PathHash]. The arrays keep their size from step to step. */
internal class PathList {
    private var ids = IntArray(INITIAL)
    private var hashes = LongArray(INITIAL)

    var size = 0
        private set

    fun id(k: Int): Int = ids[k]

    fun hash(k: Int): Long = hashes[k]

    fun clear() {
        size = 0
    }

    fun add(id: Int, hash: Long) {
        if (size == ids.size) {
            hashes = hashes.copyOf(size * 2)
            ids = ids.copyOf(size * 2)
        }
        ids[size] = id
        hashes[size++] = hash
    }

    private companion object {
        const val INITIAL = 4
    }
}
