package daphnis.core.format

import java.nio.ByteBuffer
import java.util.zip.CRC32C

/**
 * CRC-32C over everything that [H5md.read] reads from a file, in the order of [of]: numbers big-endian, doubles by
 * their bits. HDF5's own checksums cover only parts of a file.
 */
internal object H5mdChecksum {
    /** Name of the attribute of the group `parameters` that holds it, as a 64-bit integer. */
    const val ATTRIBUTE = "crc32c"

    /**
     * The checksum of [snapshots] of the same spheres. What a file holds once, such as radii and faces, is taken from
     * the first snapshot.
     */
    fun of(snapshots: List<Snapshot>): Long {
        val sum = Sum()
        val first = snapshots.first()
        val hasEdges = first.lengths.none { it.isNaN() }
        val hasImages = first.size > 0 && snapshots.all { it.image != null }
        sum.integers(intArrayOf(snapshots.size, first.size, first.normalAxis, first.slideAxis))
        sum.integers(IntArray(3) { if (first.periodic[it]) 1 else 0 })
        sum.integers(intArrayOf(if (hasEdges) 1 else 0, if (hasImages) 1 else 0))
        sum.integers(first.id)
        for (quantity in H5md.FIXED) for (column in first.columns(quantity)) sum.numbers(column)
        if (first.hasMaterials) {
            sum.numbers(first.material)
            for (name in first.materials) sum.integers(IntArray(name.length) { name[it].code })
        }
        for (snapshot in snapshots) {
            sum.long(snapshot.step)
            sum.numbers(doubleArrayOf(snapshot.time, snapshot.shearOffset))
            if (hasEdges) sum.numbers(snapshot.lengths)
            for (axis in 0..2) {
                for (quantity in H5md.CHANGING) snapshot.columns(quantity).getOrNull(axis)?.let { sum.numbers(it) }
                if (hasImages) sum.integers(snapshot.image!![axis])
            }
        }
        return sum.value
    }

    private class Sum {
        private val crc = CRC32C()
        private val block = ByteBuffer.allocate(BLOCK)

        val value: Long
            get() {
                empty()
                return crc.value
            }

        fun long(value: Long) {
            if (block.remaining() < Long.SIZE_BYTES) empty()
            block.putLong(value)
        }

        fun numbers(values: DoubleArray) {
            for (value in values) long(value.toRawBits())
        }

        fun integers(values: IntArray) {
            for (value in values) long(value.toLong())
        }

        private fun empty() {
            crc.update(block.flip())
            block.clear()
        }
    }

    private const val BLOCK = 1 shl 13
}
