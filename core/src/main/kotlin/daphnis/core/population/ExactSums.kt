package daphnis.core.population

import java.nio.ByteBuffer

/** Exact sums over what happens in steps: steps and nodes take parts, in any order, and merge them. */
internal abstract class ExactSums {
    /** How much was summed. */
    var count = 0L

    private val sums = ArrayList<ExactSum>()

    /** Whole numbers that are summed too; of a fixed length. */
    open val counts: LongArray get() = NONE

    /** How many sums are not those of nothing. */
    val size: Int get() = sums.size

    /** The sum number [k], to be added to. */
    fun sum(k: Int): ExactSum {
        while (sums.size <= k) sums += ExactSum()
        return sums[k]
    }

    /** The value of the sum number [k]. */
    fun value(k: Int): Double = if (k < sums.size) sums[k].value() else 0.0

    /** Adds [other] sums of the same kind. */
    fun merge(other: ExactSums) {
        count += other.count
        for (k in 0 until other.size) sum(k).add(other.sum(k))
        for (k in counts.indices) counts[k] += other.counts[k]
    }

    /** Makes these the sums of nothing. */
    fun clear() {
        count = 0
        for (sum in sums) sum.clear()
        counts.fill(0)
    }

    /** The most bytes that [write] takes. */
    val mostBytes: Int get() = HEAD + size * ExactSum.MOST_BYTES + counts.size * Long.SIZE_BYTES

    /** Writes the sums, for [read]. */
    fun write(into: ByteBuffer) {
        into.putLong(count).putInt(size)
        for (sum in sums) sum.write(into)
        for (number in counts) into.putLong(number)
    }

    /** Makes these the sums that [write] has written of the same kind. */
    fun read(from: ByteBuffer) {
        clear()
        count = from.long
        repeat(from.int) { sum(it).read(from) }
        for (k in counts.indices) counts[k] = from.long
    }

    private companion object {
        val NONE = LongArray(0)
        const val HEAD = Long.SIZE_BYTES + Int.SIZE_BYTES
    }
}
