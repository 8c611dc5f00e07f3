package daphnis.core.population

import java.nio.ByteBuffer

/**
 * A sum of doubles without round-off: its [value] is the true sum of all terms, rounded once, to nearest and ties to
 * even. So it does not depend on the order of the terms, nor on how they were distributed over threads or machines
 * whose sums are merged by [add].
 *
 * The true sum is held as an integer in units of 2^−1074, in chunks of 32 bits with room for carries (the small
 * superaccumulator of Neal 2015, arXiv:1505.05571). [addAll] first splits its terms into two parts each, whose sums are
 * exact in plain doubles, as in the presummation of Rump, Ogita & Oishi 2008, SIAM J. Sci. Comput. 31, 189.
 *
 * Infinities and NaN sum up as in plain addition. A sum that overflows on the way is right at the end if its value is
 * finite; otherwise it is infinite. A sum of zeros is 0.0, whatever their signs. Not thread-safe; allocates only in
 * [parts].
 */
public class ExactSum {
    // Σ chunk[i] · 2^(32 i), in units of 2^−1074; those outside least..top are 0.
    private val chunks = LongArray(CHUNKS)
    private var least = CHUNKS
    private var top = -1

    /** How many numbers the chunks have taken since carries were propagated. */
    private var pending = 0

    /** The plain sum of the terms that are not finite. */
    private var special = 0.0

    /** Makes this the empty sum: 0.0. */
    public fun clear() {
        if (top >= 0) chunks.fill(0, least, top + 1)
        least = CHUNKS
        top = -1
        pending = 0
        special = 0.0
    }

    /** Adds one [term]. */
    public fun add(term: Double) {
        val bits = term.toRawBits()
        val exponent = (bits ushr FRACTION_BITS).toInt() and NOT_FINITE
        if (exponent == NOT_FINITE) {
            special += term
            return
        }
        val fraction = bits and FRACTION
        if (exponent == 0 && fraction == 0L) return
        // A subnormal number is placed like one of exponent 1, but without the implied bit.
        val mantissa = if (exponent == 0) fraction else fraction or IMPLIED
        val position = maxOf(exponent, 1) - 1
        val chunk = position shr 5
        val shift = position and 31
        val sign = bits shr 63
        val low = (mantissa shl shift) and LOW
        val high = mantissa ushr (32 - shift)
        chunks[chunk] += (low xor sign) - sign
        chunks[chunk + 1] += (high xor sign) - sign
        if (chunk < least) least = chunk
        if (chunk >= top) top = chunk + 1
        if (++pending == MOST_PENDING) carry()
    }

    /** Adds the entries [from] until [to] of [terms], a few times faster than one by one. */
    @JvmOverloads
    public fun addAll(terms: DoubleArray, from: Int = 0, to: Int = terms.size) {
        var start = from
        while (start < to) {
            val end = minOf(to.toLong(), start + BLOCK.toLong()).toInt()
            val exponent = if (end - start < FEW) 0 else GreatestExponent.of(terms, start, end)
            if (exponent in LEAST_SPLIT..MOST_SPLIT) {
                addSplit(terms, start, end, exponent)
            } else {
                for (k in start until end) add(terms[k])
            }
            start = end
        }
    }

    /** Adds the sum in [other], which does not change. */
    public fun add(other: ExactSum) {
        special += other.special
        if (other.top < 0) return
        other.carry()
        carry()
        for (i in other.least..other.top) chunks[i] += other.chunks[i]
        least = minOf(least, other.least)
        top = maxOf(top, other.top)
        pending++
    }

    /** The sum of all terms, correctly rounded. */
    public fun value(): Double {
        if (special != 0.0) return special
        carry()
        if (top < 0) return 0.0
        val isNegative = chunks[top] < 0
        if (isNegative) negate()
        val magnitude = magnitude()
        if (isNegative) negate()
        return if (isNegative && magnitude != 0.0) -magnitude else magnitude
    }

    /**
     * Numbers whose sum without round-off is this sum: its value, the value of the remainder, and so on. Usually they
     * are few, at most 40 for a finite value. [addAll] of them gives this sum again. A sum beyond the largest double
     * takes as many of these as it is large; one that would take more than 64 numbers is given by its [value], which is
     * infinite. Empty for 0. Allocates.
     */
    public fun parts(): List<Double> {
        if (special != 0.0) return listOf(special)
        val rest = ExactSum()
        rest.add(this)
        return buildList {
            while (true) {
                val part = rest.value().coerceIn(-Double.MAX_VALUE, Double.MAX_VALUE)
                if (part == 0.0) break
                if (size == MOST_PARTS) return listOf(value())
                add(part)
                rest.add(-part)
            }
        }
    }

    /**
     * Writes the sum without round-off, in at most [MOST_BYTES], for [read].
     *
     * @throws IllegalStateException for a sum of 2^45 times the largest double or more
     */
    internal fun write(into: ByteBuffer) {
        carry()
        check(top <= TOP_WRITTEN) { "the sum is more than 2^45 times the largest double" }
        into.putDouble(special).put(least.toByte()).put((top + 1).toByte())
        for (i in least..top) into.putInt(chunks[i].toInt())
    }

    /**
     * Makes this the sum that [write] has written. Damaged bytes give another sum, or are refused.
     *
     * @throws IllegalArgumentException for bytes that are no sum; then this is the empty sum
     */
    internal fun read(from: ByteBuffer) {
        clear()
        require(from.remaining() >= HEADER_BYTES) { "a sum is cut off" }
        val infinite = from.getDouble()
        val first = from.get().toInt()
        val end = from.get().toInt()
        require(infinite == 0.0 || !infinite.isFinite()) { "a sum has $infinite in place of an infinity" }
        special = infinite
        if (first == CHUNKS && end == 0) return
        val isPossible =
            first in 0..<end && end <= TOP_WRITTEN + 1 && from.remaining() >= (end - first) * Int.SIZE_BYTES
        if (!isPossible) special = 0.0
        require(isPossible) { "a sum has chunks $first until $end in ${from.remaining()} bytes" }
        for (i in first until end) chunks[i] = from.getInt().toLong() and LOW
        least = first
        top = end - 1
        // The highest one has the sign.
        chunks[top] = chunks[top].toInt().toLong()
    }

    /**
     * Adds at most [BLOCK] terms of magnitudes below 2^(e + 1), where [exponent] is e with its bias. Adding a number
     * and subtracting it again rounds a term to a multiple of 2^(e − 39), and 4096 of those add up exactly, in any
     * order. The remainders are rounded to multiples of 2^(e − 80) in the same way. What remains then, of terms that
     * are small compared with the largest, is added one by one; most blocks have no such terms.
     */
    private fun addSplit(terms: DoubleArray, from: Int, to: Int, exponent: Int) {
        val coarse = 1.5 * powerOfTwo(exponent + BLOCK_BITS + 1)
        val fine = 1.5 * powerOfTwo(exponent + BLOCK_BITS - SPLIT_BITS)
        var high = 0.0
        var low = 0.0
        var otherHigh = 0.0
        var otherLow = 0.0
        var left = 0L
        var k = from
        // Two chains of additions, since each addition waits for the one before.
        while (k < to - 1) {
            val term = terms[k]
            val other = terms[k + 1]
            val upper = term + coarse - coarse
            val otherUpper = other + coarse - coarse
            val rest = term - upper
            val otherRest = other - otherUpper
            val lower = rest + fine - fine
            val otherLower = otherRest + fine - fine
            high += upper
            otherHigh += otherUpper
            low += lower
            otherLow += otherLower
            left = left or (rest - lower).toRawBits() or (otherRest - otherLower).toRawBits()
            k += 2
        }
        if (k < to) add(terms[k])
        add(high + otherHigh)
        add(low + otherLow)
        if (left shl 1 != 0L) addLeft(terms, from, k, coarse, fine)
    }

    /** Adds what is left of the terms of a block without their multiples of 2^(e − 80). */
    private fun addLeft(terms: DoubleArray, from: Int, to: Int, coarse: Double, fine: Double) {
        for (k in from until to) {
            val rest = terms[k] - (terms[k] + coarse - coarse)
            add(rest - (rest + fine - fine))
        }
    }

    /**
     * Makes every chunk but the top one a number in 0 until 2^32, and the top one, which has the sign, less than 2^31.
     */
    private fun carry() {
        if (pending == 0) return
        pending = 0
        for (i in least until top) {
            chunks[i + 1] += chunks[i] shr 32
            chunks[i] = chunks[i] and LOW
        }
        while (chunks[top] != chunks[top].toInt().toLong()) {
            chunks[top + 1] += chunks[top] shr 32
            chunks[top] = chunks[top] and LOW
            top++
        }
    }

    private fun negate() {
        for (i in least..top) chunks[i] = -chunks[i]
        pending = 1
        carry()
    }

    /** The value of chunks that are all >= 0. */
    private fun magnitude(): Double {
        var i = top
        while (i > least && chunks[i] == 0L) i--
        if (chunks[i] == 0L) return 0.0
        val last = 32 * i + 63 - chunks[i].countLeadingZeroBits() - FRACTION_BITS
        // All bits fit: the result is the double of these bits, whether subnormal or not.
        if (last <= 0) return Double.fromBits(chunks[0] or (chunks[1] shl 32))
        if (last > MOST_POSITION) return Double.POSITIVE_INFINITY
        var mantissa = bitsFrom(last)
        if (isRoundedUp(last, mantissa)) mantissa++
        // The implied bit of the mantissa makes up for the 1 that the exponent lacks; a rounding up carries into the
        // exponent.
        return Double.fromBits((last.toLong() shl FRACTION_BITS) + mantissa)
    }

    /** The bits from [position] on to the highest one. */
    private fun bitsFrom(position: Int): Long {
        val i = position shr 5
        val shift = position and 31
        val bits = (chunks[i] ushr shift) or (chunks[i + 1] shl (32 - shift))
        return if (shift == 0) bits else bits or (chunks[i + 2] shl (64 - shift))
    }

    private fun isRoundedUp(last: Int, mantissa: Long): Boolean {
        val i = (last - 1) shr 5
        val half = 1L shl ((last - 1) and 31)
        if (chunks[i] and half == 0L) return false
        if (mantissa and 1L == 1L || chunks[i] and (half - 1) != 0L) return true
        for (j in least until i) if (chunks[j] != 0L) return true
        return false
    }

    private fun powerOfTwo(exponent: Int): Double = Double.fromBits(exponent.toLong() shl FRACTION_BITS)

    internal companion object {
        /** Bytes of the longest sum that is written. */
        const val MOST_BYTES = 10 + 67 * Int.SIZE_BYTES
        private const val HEADER_BYTES = Double.SIZE_BYTES + 2

        /** 65 for the largest double, with room for the sum of 2^63 of those. */
        private const val CHUNKS = 68

        /** The top chunk of what is written: below it there is room for merging 2^31 sums. */
        private const val TOP_WRITTEN = CHUNKS - 2
        private const val LOW = 0xFFFFFFFFL
        private const val FRACTION_BITS = 52
        private const val FRACTION = (1L shl FRACTION_BITS) - 1
        private const val IMPLIED = 1L shl FRACTION_BITS
        private const val NOT_FINITE = 0x7FF

        /** The last bit of the largest double, in bits from the last bit of the least. */
        private const val MOST_POSITION = 2045

        private const val MOST_PARTS = 64

        /** Each term adds up to 2^52 to a chunk. */
        private const val MOST_PENDING = 1024

        /** Fewer terms than this are added one by one. */
        private const val FEW = 8
        private const val BLOCK_BITS = 12
        private const val BLOCK = 1 shl BLOCK_BITS
        private const val SPLIT_BITS = 40

        /** Exponents, with their bias, at which a block can be split without underflow and overflow. */
        private const val LEAST_SPLIT = 100
        private const val MOST_SPLIT = 2000
    }
}
