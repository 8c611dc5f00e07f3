package daphnis.core.format.hdf5

/**
 * A type of numbers or texts.
 *
 * @property size bytes of one
 * @property description as it is in a file
 */
internal class Datatype private constructor(val size: Int, bytes: Bytes) {
    val description: ByteArray = bytes.array()

    companion object {
        /** Version 1 in the upper half, the class in the lower. */
        private const val FIXED_POINT = 0x10
        private const val FLOATING_POINT = 0x11
        private const val TEXT = 0x13

        /** Signed integers of 32 bits. */
        val INT: Datatype = integer(Int.SIZE_BYTES)

        /** Signed integers of 64 bits. */
        val LONG: Datatype = integer(Long.SIZE_BYTES)

        /** IEEE 754 of 64 bits: the sign is bit 63, eleven bits of exponent from 52 on, an implied leading one. */
        val DOUBLE: Datatype = Datatype(
            Double.SIZE_BYTES,
            Bytes().byte(FLOATING_POINT).byte(0x20).byte(63).byte(0).int(Double.SIZE_BYTES)
                .short(0).short(64).byte(52).byte(11).byte(0).byte(52).int(1023),
        )

        /** Texts in UTF-8 of at most [most] bytes, which end with a zero. */
        fun text(most: Int): Datatype = Datatype(most + 1, Bytes().byte(TEXT).byte(0x10).byte(0).byte(0).int(most + 1))

        private fun integer(size: Int) = Datatype(
            size,
            Bytes().byte(FIXED_POINT).byte(0x08).byte(0).byte(0).int(size).short(0).short(size * Byte.SIZE_BITS),
        )
    }
}
