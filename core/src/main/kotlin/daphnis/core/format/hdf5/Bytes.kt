package daphnis.core.format.hdf5

/** Bytes that grow, numbers little-endian, as all of HDF5's metadata. */
internal class Bytes(capacity: Int = 256) {
    private var bytes = ByteArray(capacity)

    /** Number of bytes so far. */
    var size = 0
        private set

    /** Puts the lowest [width] bytes of [value]. */
    fun number(value: Long, width: Int): Bytes {
        reserve(width)
        for (k in 0 until width) bytes[size++] = (value ushr (k * Byte.SIZE_BITS)).toByte()
        return this
    }

    fun byte(value: Int): Bytes = number(value.toLong(), 1)

    fun short(value: Int): Bytes = number(value.toLong(), Short.SIZE_BYTES)

    fun int(value: Int): Bytes = number(value.toLong(), Int.SIZE_BYTES)

    /** An address, length or extent. */
    fun long(value: Long): Bytes = number(value, Long.SIZE_BYTES)

    fun all(values: ByteArray): Bytes {
        reserve(values.size)
        values.copyInto(bytes, size)
        size += values.size
        return this
    }

    fun all(values: Bytes): Bytes = all(values.array())

    /** Puts zeros until there are [end] bytes. */
    fun zerosTo(end: Int): Bytes = all(ByteArray(end - size))

    fun text(value: String): Bytes = all(value.toByteArray())

    /** Puts the checksum over all so far, see [Lookup3]. */
    fun checksum(): Bytes = int(Lookup3.of(bytes, size))

    fun array(): ByteArray = bytes.copyOf(size)

    private fun reserve(more: Int) {
        val least = Math.addExact(size, more)
        if (least > bytes.size) bytes = bytes.copyOf(maxOf(least, 2 * bytes.size))
    }
}
