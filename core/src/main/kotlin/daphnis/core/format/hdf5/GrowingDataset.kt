package daphnis.core.format.hdf5

import daphnis.core.format.hdf5.Messages.Message
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * A dataset that grows by frames along its first axis, which has no end; other programs can add more. One chunk is in
 * memory. It has many frames where these are small, or a part of one where they are large. A dataset that ends before
 * its first chunk is full has a chunk as long as itself.
 *
 * @param frame extents of a frame, slowest first; none for a number
 * @param isPacked whether chunks are compressed
 */
internal class GrowingDataset(
    file: Hdf5File,
    private val type: Datatype,
    private val frame: IntArray,
    private val isPacked: Boolean,
) : Hdf5Object(file) {
    private val rows = frame.firstOrNull() ?: 1
    private val rowBytes = frame.drop(1).fold(type.size) { all, extent -> Math.multiplyExact(all, extent) }

    /** Chunks of one frame, of nearly the same size. */
    private val parts = ceil(rows, maxOf(1, MOST_BYTES / rowBytes))
    private val chunkRows = ceil(rows, parts)
    private var chunkFrames = if (parts > 1) 1 else maxOf(1, mostFrames() / (rows * rowBytes))
    private val chunk = ByteBuffer.allocate(chunkFrames * chunkRows * rowBytes).order(ByteOrder.LITTLE_ENDIAN)

    private var frames = 0L
    private var held = 0

    /** Address and bytes of each chunk, in turn. */
    private var places = LongArray(FIRST)
    private var chunks = 0

    private fun mostFrames() = if (isPacked) MOST_BYTES else MOST_BARE_BYTES

    /**
     * Adds a frame.
     *
     * @param put puts the rows from its first number until its second into the buffer
     */
    @Throws(IOException::class)
    fun append(put: (ByteBuffer, Int, Int) -> Unit) {
        for (from in 0 until rows step chunkRows) {
            put(chunk, from, minOf(from + chunkRows, rows))
            if (parts > 1) flush()
        }
        frames++
        if (parts == 1 && ++held == chunkFrames) flush()
    }

    /** Writes the chunk, zeros where nothing was put. */
    private fun flush() {
        val bytes = chunk.array()
        val size = chunkFrames * chunkRows * rowBytes
        bytes.fill(0, chunk.position(), size)
        val address: Long
        val stored: Int
        if (isPacked) {
            file.packing.pack(bytes, size, type.size)
            stored = file.packing.size
            address = file.append(file.packing.packed, stored)
        } else {
            stored = size
            address = file.append(bytes, size)
        }
        if (2 * chunks == places.size) places = places.copyOf(2 * places.size)
        places[2 * chunks] = address
        places[2 * chunks++ + 1] = stored.toLong()
        chunk.clear()
        held = 0
    }

    override fun finish() {
        if (held == 0) return
        if (chunks == 0) chunkFrames = held
        flush()
    }

    override fun mostChunks(): Int = chunks

    private fun place(k: Int): LongArray = place(k / parts * chunkFrames.toLong(), k % parts * chunkRows.toLong())

    private fun place(frame: Long, row: Long) = LongArray(this.frame.size + 1).also {
        it[0] = frame
        if (it.size > 1) it[1] = row
    }

    override fun messages(index: ChunkIndex): List<Message> {
        val end = place(chunks.toLong() / parts * chunkFrames, 0)
        val root = index.write(chunks, ::place, { places[2 * it + 1].toInt() }, { places[2 * it] }, end)
        val shape = intArrayOf(chunkFrames) + frame
        if (frame.isNotEmpty()) shape[1] = chunkRows
        return listOfNotNull(
            Messages.dataspace(longArrayOf(frames) + frame.map { it.toLong() }, grows = true),
            Messages.datatype(type),
            Messages.fillValue(grows = true),
            if (isPacked) Messages.filters(type, Packing.LEVEL) else null,
            Messages.chunked(root, shape, type),
        )
    }

    private companion object {
        /** Of a chunk: below 1 MiB, the cache that the HDF5 library gives a dataset. */
        const val MOST_BYTES = 768 * 1024

        /** Of a chunk that is written as it is, which has room at the end of the dataset. */
        const val MOST_BARE_BYTES = 8 * 1024
        const val FIRST = 4

        fun ceil(number: Int, by: Int): Int = (number - 1) / by + 1
    }
}
