package daphnis.core.format

import java.nio.ByteBuffer
import java.util.zip.CRC32C

/**
 * CRC-32C over everything that [H5md.read] reads from a file, in a fixed order: numbers big-endian, doubles by their
 * bits. HDF5's own checksums cover only parts of a file. What a file holds once, such as faces, is taken from the [first]
 * state; radii and masses are again where they differ from those. The number of states comes first and is known last, so what follows it has a sum of its own.
 *
 * @param first the first state, which is not added by this
 */
internal class H5mdChecksum(first: Snapshot) {
    private val hasEdges = first.lengths.none { it.isNaN() }
    private val axes = intArrayOf(first.normalAxis, first.slideAxis)
    private val periodic = first.periodic
    private val size = first.size
    private val bound = first.bound
    private val fixed = H5md.FIXED.flatMap { first.columns(it) }
    private val species = first.material
    private val plain = Sum()

    /** The sum with images; null from the first state on that does not know them. */
    private var imaged = if (first.size > 0 && first.image != null) Sum() else null
    private var count = 0

    private inline fun sums(put: Sum.() -> Unit) {
        plain.put()
        imaged?.put()
    }

    init {
        sums {
            integers(first.id)
            for (column in fixed) numbers(column)
            if (first.hasMaterials) {
                numbers(first.material)
                for (name in first.materials) integers(IntArray(name.length) { name[it].code })
            }
        }
    }

    /** Takes in the next state. */
    fun add(state: Snapshot) {
        count++
        val image = state.image
        if (image == null) imaged = null
        sums {
            long(state.step)
            numbers(doubleArrayOf(state.time, state.shearOffset))
            if (hasEdges) numbers(state.lengths)
        }
        for ((k, column) in H5md.FIXED.flatMap { state.columns(it) }.withIndex()) {
            if (!column.contentEquals(fixed[k])) sums { numbers(column) }
        }
        if (!state.material.contentEquals(species)) sums { numbers(state.material) }
        for (axis in 0..2) {
            for (quantity in H5md.CHANGING) state.columns(quantity).getOrNull(axis)?.let { sums { numbers(it) } }
            imaged?.integers(image!![axis])
        }
    }

    /** The checksum of all states that were added; none can be added after it. */
    fun value(): Long {
        val body = imaged ?: plain
        if (count == 1 && bound != null) body.integers(bound)
        val head = Sum()
        head.integers(intArrayOf(count, size))
        head.integers(axes)
        head.integers(IntArray(3) { if (periodic[it]) 1 else 0 })
        head.integers(intArrayOf(if (hasEdges) 1 else 0, if (imaged != null) 1 else 0))
        return Crc32cJoin.of(head.value(), body.value(), body.bytes)
    }

    private class Sum {
        private val crc = CRC32C()
        private val block = ByteBuffer.allocate(BLOCK)

        /** Number of bytes, once [value] was asked for. */
        var bytes = 0L
            private set

        fun value(): Long {
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
            bytes += block.position()
            crc.update(block.flip())
            block.clear()
        }
    }

    companion object {
        /** Name of the attribute of the group `parameters` that holds it, as a 64-bit integer. */
        const val ATTRIBUTE = "crc32c"
        private const val BLOCK = 1 shl 13

        /** The checksum of [snapshots] of the same spheres. */
        fun of(snapshots: List<Snapshot>): Long {
            val sum = H5mdChecksum(snapshots.first())
            for (snapshot in snapshots) sum.add(snapshot)
            return sum.value()
        }
    }
}
