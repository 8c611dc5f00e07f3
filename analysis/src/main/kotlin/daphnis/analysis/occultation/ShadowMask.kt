package daphnis.analysis.occultation

/**
 * Which points of a lattice lie in a shadow: [rows] rows of [places] points, one bit each.
 */
internal class ShadowMask(val rows: Int, val places: Int) {
    private val words = (places + 63) / 64
    private val bits = LongArray(Math.multiplyExact(rows, words))

    /** How many times a word has been written: what the shadows have cost. */
    var written = 0L
        private set

    /** Sets the points [from] to [to] of [row], both included; all lie in it. */
    fun block(row: Int, from: Int, to: Int) {
        val first = row * words + (from shr 6)
        val last = row * words + (to shr 6)
        val head = -1L shl (from and 63)
        val tail = -1L ushr (63 - (to and 63))
        written += last - first + 1
        if (first == last) {
            bits[first] = bits[first] or (head and tail)
            return
        }
        bits[first] = bits[first] or head
        for (k in first + 1 until last) bits[k] = -1L
        bits[last] = bits[last] or tail
    }

    /** Whether every point of every row is set. */
    fun isFull(): Boolean = (0 until rows).all { blocked(it, 0, places) == places }

    /** How many of the points [from] until [end] of [row] are set. */
    fun blocked(row: Int, from: Int, end: Int): Int {
        if (end <= from) return 0
        val first = row * words + (from shr 6)
        val last = row * words + (end - 1 shr 6)
        val head = -1L shl (from and 63)
        val tail = -1L ushr (63 - (end - 1 and 63))
        if (first == last) return (bits[first] and head and tail).countOneBits()
        var count = (bits[first] and head).countOneBits() + (bits[last] and tail).countOneBits()
        for (k in first + 1 until last) count += bits[k].countOneBits()
        return count
    }
}
