package daphnis.core.initial

/**
 * Indices of [radii], all > 0, from the largest radius to the smallest, equal ones in their own order. Sorts by digits
 * of 16 bits, the lowest first: without objects, and equal radii, of which there may be millions, cost nothing.
 */
internal fun largestFirst(radii: DoubleArray): IntArray {
    var order = IntArray(radii.size) { it }
    var other = IntArray(0)
    val counts = IntArray(DIGITS)
    for (shift in 0 until Double.SIZE_BITS step DIGIT_BITS) {
        counts.fill(0)
        for (r in radii) counts[digit(r, shift)]++
        if (counts.any { it == radii.size }) continue
        var start = 0
        for (d in 0 until DIGITS) start += counts[d].also { counts[d] = start }
        if (other.isEmpty()) other = IntArray(radii.size)
        for (k in order) other[counts[digit(radii[k], shift)]++] = k
        order = other.also { other = order }
    }
    return order
}

/** Bits of a positive double grow with it, so their complement falls. */
private fun digit(radius: Double, shift: Int): Int = (radius.toRawBits().inv() ushr shift).toInt() and (DIGITS - 1)

private const val DIGIT_BITS = 16
private const val DIGITS = 1 shl DIGIT_BITS
