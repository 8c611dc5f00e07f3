package daphnis.analysis.movie

import java.io.OutputStream

/** The compression of GIF: variable codes of up to 12 bits for runs of bytes, in blocks of up to 255 bytes. */
internal class Lzw(private val out: OutputStream) {
    private val block = ByteArray(MOST_IN_BLOCK)
    private var inBlock = 0
    private var bits = 0
    private var bitCount = 0

    /** Code of the run that has the code `key shr 8` followed by the byte `key and 0xff`; hashed, 0 for none. */
    private val keys = IntArray(SLOTS)
    private val codes = IntArray(SLOTS)
    private var next = 0
    private var width = 0

    /** Writes all of [bytes]. */
    fun write(bytes: ByteArray) {
        out.write(BITS_OF_BYTE)
        reset()
        put(CLEAR)
        var run = bytes[0].toInt() and 0xff
        for (k in 1 until bytes.size) {
            val byte = bytes[k].toInt() and 0xff
            // From 1, so that 0 is an empty slot.
            val key = (run shl BITS_OF_BYTE or byte) + 1
            var slot = key * SPREAD ushr SHIFT
            while (keys[slot] != 0 && keys[slot] != key) slot = slot + 1 and SLOTS - 1
            if (keys[slot] == key) {
                run = codes[slot]
                continue
            }
            put(run)
            run = byte
            if (next == MOST_CODES) {
                put(CLEAR)
                reset()
            } else {
                // The reader learns a code one step later, so the codes grow one later than the table.
                if (next == 1 shl width) width++
                keys[slot] = key
                codes[slot] = next++
            }
        }
        put(run)
        put(END)
        if (bitCount > 0) byte(bits)
        flush()
        out.write(0)
    }

    private fun reset() {
        keys.fill(0)
        next = END + 1
        width = BITS_OF_BYTE + 1
    }

    private fun put(code: Int) {
        bits = bits or (code shl bitCount)
        bitCount += width
        while (bitCount >= BITS_OF_BYTE) {
            byte(bits)
            bits = bits ushr BITS_OF_BYTE
            bitCount -= BITS_OF_BYTE
        }
    }

    private fun byte(value: Int) {
        block[inBlock++] = value.toByte()
        if (inBlock == MOST_IN_BLOCK) flush()
    }

    private fun flush() {
        if (inBlock == 0) return
        out.write(inBlock)
        out.write(block, 0, inBlock)
        inBlock = 0
    }

    private companion object {
        const val BITS_OF_BYTE = 8
        const val CLEAR = 256
        const val END = 257
        const val MOST_CODES = 4096
        const val MOST_IN_BLOCK = 255
        const val SLOTS = 1 shl 14
        const val SHIFT = 32 - 14

        /** 2³² over the golden ratio. */
        const val SPREAD = -1640531527
    }
}
