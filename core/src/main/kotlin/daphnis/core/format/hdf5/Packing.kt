package daphnis.core.format.hdf5

import java.util.zip.Deflater

/** HDF5's filters shuffle and deflate, one block after the other. */
internal class Packing {
    private val deflater = Deflater(LEVEL)
    private var shuffled = ByteArray(0)

    /** The result of the last [pack], [size] bytes from 0 on. */
    var packed = ByteArray(0)
        private set
    var size = 0
        private set

    /** Packs the first [count] of [bytes], which are numbers of [width] bytes each. */
    fun pack(bytes: ByteArray, count: Int, width: Int) {
        shuffle(bytes, count, width)
        deflater.reset()
        deflater.setInput(shuffled, 0, count)
        deflater.finish()
        size = 0
        while (!deflater.finished()) {
            if (size == packed.size) packed = packed.copyOf(maxOf(count + count / MARGIN + LEAST, 2 * size))
            size += deflater.deflate(packed, size, packed.size - size)
        }
    }

    /** First bytes of all numbers, then the second ones, and so on. */
    private fun shuffle(bytes: ByteArray, count: Int, width: Int) {
        if (shuffled.size < count) shuffled = ByteArray(count)
        val numbers = count / width
        for (part in 0 until width) {
            var from = part
            for (to in part * numbers until (part + 1) * numbers) {
                shuffled[to] = bytes[from]
                from += width
            }
        }
    }

    fun end() {
        deflater.end()
    }

    companion object {
        const val LEVEL = 4
        private const val LEAST = 64
        private const val MARGIN = 1000
    }
}
