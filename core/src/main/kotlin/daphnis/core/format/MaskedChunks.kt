package daphnis.core.format

import io.jhdf.api.dataset.ChunkedDataset
import io.jhdf.dataset.chunked.Chunk
import io.jhdf.dataset.chunked.ChunkedDatasetBase
import io.jhdf.filter.ByteShuffleFilter
import io.jhdf.filter.DeflatePipelineFilter
import io.jhdf.filter.Filter
import io.jhdf.filter.LzfFilter
import io.jhdf.`object`.datatype.FixedPoint
import io.jhdf.`object`.datatype.FloatingPoint
import io.jhdf.`object`.datatype.OrderedDataType
import java.nio.ByteBuffer
import java.util.BitSet

/**
 * The numbers of a dataset of which some chunks went without some of its filters, as HDF5 stores those that a filter
 * could not make smaller, or whose chunks end with a checksum by Fletcher. A chunk's mask has a bit for each filter that
 * was left out; the library, jhdf 0.13, reads the mask and applies all filters nevertheless, and leaves the checksum in
 * the data.
 */
internal object MaskedChunks {
    private val filters: Map<Int, Filter> by lazy {
        listOf(DeflatePipelineFilter(), ByteShuffleFilter(), LzfFilter()).associateBy { it.id }
    }
    private val lookup by lazy {
        ChunkedDatasetBase::class.java.getDeclaredMethod("getChunkLookup").apply { isAccessible = true }
    }

    /** Doubles or longs of [dataset], the last index fastest; null where the library reads it. */
    fun numbers(dataset: ChunkedDataset): Any? {
        if (dataset !is ChunkedDatasetBase || dataset.filters.isEmpty()) return null
        val chunks = (lookup(dataset) as Map<*, *>).values.map { it as Chunk }
        if (chunks.all { it.filterMask.isEmpty } && dataset.filters.none { it.id == FLETCHER }) return null
        val shape = IntArray(dataset.dimensionsAsLong.size) { Math.toIntExact(dataset.dimensionsAsLong[it]) }
        val wide = dataset.dataType.size
        val whole = ByteArray(Math.toIntExact(shape.fold(wide.toLong()) { all, extent -> all * extent }))
        for (chunk in chunks) {
            val offset = IntArray(shape.size) { Math.toIntExact(chunk.chunkOffset[it]) }
            val raw = dataset.getRawChunkBuffer(offset)
            val bytes = decoded(dataset, ByteArray(raw.remaining()).also { raw.get(it) }, chunk.filterMask)
            place(bytes, dataset.chunkDimensions, offset, whole, shape, wide)
        }
        return numbers(whole, dataset.dataType as OrderedDataType, wide)
    }

    private fun decoded(dataset: ChunkedDataset, raw: ByteArray, mask: BitSet): ByteArray {
        var bytes = raw
        for ((k, filter) in dataset.filters.withIndex().reversed()) {
            if (mask[k]) continue
            if (filter.id == FLETCHER) {
                bytes = bytes.copyOf(bytes.size - CHECKSUM_BYTES)
                continue
            }
            val found = requireNotNull(filters[filter.id]) { "the filter ${filter.name} is not known" }
            bytes = found.decode(bytes, filter.filterData)
        }
        return bytes
    }

    /** Copies the part of a chunk at [offset] that is inside the dataset, line by line. */
    private fun place(
        chunk: ByteArray,
        extents: IntArray,
        offset: IntArray,
        whole: ByteArray,
        shape: IntArray,
        wide: Int,
    ) {
        val last = shape.size - 1
        val line = minOf(extents[last], shape[last] - offset[last]) * wide
        for (row in 0 until extents.dropLast(1).fold(1) { all, extent -> all * extent }) {
            var rest = row
            var at = offset[last].toLong()
            var step = shape[last].toLong()
            var isInside = true
            for (axis in last - 1 downTo 0) {
                val index = offset[axis] + rest % extents[axis]
                rest /= extents[axis]
                isInside = isInside && index < shape[axis]
                at += index * step
                step *= shape[axis]
            }
            val from = row * extents[last] * wide
            if (isInside) chunk.copyInto(whole, (at * wide).toInt(), from, from + line)
        }
    }

    private fun numbers(bytes: ByteArray, type: OrderedDataType, wide: Int): Any {
        val buffer = ByteBuffer.wrap(bytes).order(type.byteOrder)
        val count = bytes.size / wide
        if (type is FloatingPoint && wide == Double.SIZE_BYTES) return DoubleArray(count) { buffer.getDouble() }
        if (type is FloatingPoint &&
            wide == Float.SIZE_BYTES
        ) {
            return DoubleArray(count) { buffer.getFloat().toDouble() }
        }
        require(type is FixedPoint && (type.isSigned || wide < Long.SIZE_BYTES)) {
            "numbers of $wide bytes are not read"
        }
        val mask = if (type.isSigned || wide == Long.SIZE_BYTES) -1L else (1L shl 8 * wide) - 1
        return LongArray(count) {
            mask and when (wide) {
                1 -> buffer.get().toLong()
                2 -> buffer.getShort().toLong()
                4 -> buffer.getInt().toLong()
                else -> buffer.getLong()
            }
        }
    }

    private const val FLETCHER = 3
    private const val CHECKSUM_BYTES = 4
}
