package daphnis.core.format

/**
 * The CRC-32C of bytes in two parts, from those of the parts. A sum is a polynomial over the integers modulo 2, the
 * highest bit its constant; n bytes behind it multiply it by x to the power of 8 n, modulo the one of the sum.
 */
internal object Crc32cJoin {
    private const val POLYNOMIAL = 0x82f63b78.toInt()
    private const val ONE = 1 shl 31
    private const val BYTE = ONE ushr 8

    /** The sum of bytes with the sum [first], before [bytes] others with the sum [second]. */
    fun of(first: Long, second: Long, bytes: Long): Long {
        var power = ONE
        var square = BYTE
        var left = bytes
        while (left > 0) {
            if (left and 1 == 1L) power = product(power, square)
            square = product(square, square)
            left = left ushr 1
        }
        return (product(power, first.toInt()) xor second.toInt()).toLong() and 0xffff_ffffL
    }

    private fun product(a: Int, b: Int): Int {
        var sum = 0
        var factor = b
        var bit = ONE
        while (bit != 0) {
            if (a and bit != 0) sum = sum xor factor
            factor = (factor ushr 1) xor (if (factor and 1 == 1) POLYNOMIAL else 0)
            bit = bit ushr 1
        }
        return sum
    }
}
