package daphnis.core.format.hdf5

import java.io.Closeable
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.TRUNCATE_EXISTING
import java.nio.file.StandardOpenOption.WRITE

/**
 * An HDF5 file that is written from its beginning to its end, with datasets that grow. Chunks go to the file as they
 * fill; headers and indices follow when all is there, and last the superblock at the front, without which nothing takes
 * the file for HDF5. From the *HDF5 File Format Specification*, version 3.0: superblock and headers of version 2, which
 * the HDF5 library reads since 1.8. The same content gives the same bytes.
 */
internal class Hdf5File(path: Path) : Closeable {
    private val channel = FileChannel.open(path, CREATE, TRUNCATE_EXISTING, WRITE)

    /** Compresses every dataset, one chunk after the other. */
    val packing: Packing = Packing()

    /** The group `/`. */
    val root: Hdf5Group = Hdf5Group(this)

    /** Where the next byte goes. */
    var position: Long = SUPERBLOCK.toLong()
        private set

    /** Writes [size] of [bytes] and returns their address. */
    @Throws(IOException::class)
    fun append(bytes: ByteArray, size: Int = bytes.size): Long {
        val address = position
        put(ByteBuffer.wrap(bytes, 0, size), address)
        position += size
        return address
    }

    private fun put(bytes: ByteBuffer, address: Long) {
        var at = address
        while (bytes.hasRemaining()) at += channel.write(bytes, at)
    }

    /** Writes all that has not been written. Nothing may be put into the file after it. */
    @Throws(IOException::class)
    fun finish() {
        root.finish()
        val half = if (root.mostChunks() <= 2 * SMALL_HALF) SMALL_HALF else USUAL_HALF
        val top = root.write(ChunkIndex(this, half))
        val extension =
            if (half == USUAL_HALF) Messages.NONE else append(Messages.header(listOf(Messages.halfFanout(half))))
        val head = Bytes(SUPERBLOCK).all(SIGNATURE).byte(2).byte(Long.SIZE_BYTES).byte(Long.SIZE_BYTES).byte(0)
            .long(0).long(extension).long(position).long(top).checksum()
        put(ByteBuffer.wrap(head.array()), 0)
    }

    override fun close() {
        packing.end()
        channel.close()
    }

    private companion object {
        const val SUPERBLOCK = 48
        val SIGNATURE =
            byteArrayOf(0x89.toByte(), 'H'.code.toByte(), 'D'.code.toByte(), 'F'.code.toByte(), 13, 10, 26, 10)

        /** What the HDF5 library takes where the file does not say it. */
        const val USUAL_HALF = 32

        /** A node has all its room from the beginning, so 32 makes a file of one small state half as long again. */
        const val SMALL_HALF = 4
    }
}
