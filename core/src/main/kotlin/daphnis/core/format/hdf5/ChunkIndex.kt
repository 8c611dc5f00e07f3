package daphnis.core.format.hdf5

/**
 * Where the chunks of a dataset lie: a B-tree of version 1, chapter III.A.1 of the specification. Chunks are in the
 * order of their places, so the tree is built from its leaves up, every node but the last of a level full.
 *
 * @param halfFanout half the most children of a node, the same for the whole file
 */
internal class ChunkIndex(private val file: Hdf5File, private val halfFanout: Int) {
    /** A chunk or a node below: where it begins in the dataset, its bytes in the file, and where these are. */
    private class Child(val place: LongArray, val bytes: Int, val address: Long)

    /**
     * Writes the tree of [count] chunks.
     *
     * @param place of each chunk: its first element along each axis
     * @param end as a place, behind every chunk
     * @return address of the root
     */
    fun write(
        count: Int,
        place: (Int) -> LongArray,
        bytes: (Int) -> Int,
        address: (Int) -> Long,
        end: LongArray,
    ): Long {
        if (count == 0) return Messages.NONE
        var children = List(count) { Child(place(it), bytes(it), address(it)) }
        var level = 0
        do children = nodes(level++, children, end) while (children.size > 1)
        return children.single().address
    }

    private fun nodes(level: Int, children: List<Child>, end: LongArray): List<Child> {
        val groups = children.chunked(2 * halfFanout)
        val size = size(end.size)
        val first = file.position
        fun sibling(k: Int) = if (k in groups.indices) first + k.toLong() * size else Messages.NONE
        return groups.mapIndexed { k, group ->
            val node = Bytes(size).text("TREE").byte(1).byte(level).short(group.size)
                .long(sibling(k - 1)).long(sibling(k + 1))
            for (child in group) node.key(child).long(child.address)
            node.key(groups.getOrNull(k + 1)?.first() ?: Child(end, 0, 0)).zerosTo(size)
            Child(group[0].place, group[0].bytes, file.append(node.array()))
        }
    }

    private fun Bytes.key(child: Child): Bytes {
        int(child.bytes).int(0)
        for (first in child.place) long(first)
        // The axis of the bytes of an element.
        return long(0)
    }

    /** Bytes of a node, full or not, of a dataset of [rank] axes. */
    private fun size(rank: Int): Int {
        val key = 2 * Int.SIZE_BYTES + (rank + 1) * Long.SIZE_BYTES
        return HEAD + (2 * halfFanout + 1) * key + 2 * halfFanout * Long.SIZE_BYTES
    }

    private companion object {
        const val HEAD = 24
    }
}
