package daphnis.core.format.hdf5

/** The checksum of HDF5's metadata: `hashlittle` of Bob Jenkins' lookup3 (2006), begun with 0. */
internal object Lookup3 {
    private const val START = 0xdeadbeef.toInt()
    private const val BLOCK = 12

    /** The checksum of the first [size] of [bytes]. */
    fun of(bytes: ByteArray, size: Int): Int {
        var a = START + size
        var b = a
        var c = a
        var at = 0
        while (size - at > BLOCK) {
            a += word(bytes, at, size)
            b += word(bytes, at + 4, size)
            c += word(bytes, at + 8, size)
            a = (a - c) xor c.rotateLeft(4)
            c += b
            b = (b - a) xor a.rotateLeft(6)
            a += c
            c = (c - b) xor b.rotateLeft(8)
            b += a
            a = (a - c) xor c.rotateLeft(16)
            c += b
            b = (b - a) xor a.rotateLeft(19)
            a += c
            c = (c - b) xor b.rotateLeft(4)
            b += a
            at += BLOCK
        }
        if (at == size) return c
        a += word(bytes, at, size)
        b += word(bytes, at + 4, size)
        c += word(bytes, at + 8, size)
        c = (c xor b) - b.rotateLeft(14)
        a = (a xor c) - c.rotateLeft(11)
        b = (b xor a) - a.rotateLeft(25)
        c = (c xor b) - b.rotateLeft(16)
        a = (a xor c) - c.rotateLeft(4)
        b = (b xor a) - a.rotateLeft(14)
        return (c xor b) - b.rotateLeft(24)
    }

    /** Four bytes from [at], little-endian; those from [end] on count as 0. */
    private fun word(bytes: ByteArray, at: Int, end: Int): Int {
        var word = 0
        for (k in 0 until 4) {
            if (at + k < end) word = word or ((bytes[at + k].toInt() and 0xff) shl (k * Byte.SIZE_BITS))
        }
        return word
    }
}
