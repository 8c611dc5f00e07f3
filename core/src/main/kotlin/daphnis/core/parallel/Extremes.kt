package daphnis.core.parallel

import kotlin.math.abs

/** Least, greatest and greatest absolute entry of an array, found by all workers of a loop. NaN is ignored. */
public class Extremes {
    public var least: Double = Double.POSITIVE_INFINITY
        private set
    public var greatest: Double = Double.NEGATIVE_INFINITY
        private set

    /** max |a|; 0 for an empty array. */
    public val magnitude: Double get() = if (least > greatest) 0.0 else Math.max(abs(least), abs(greatest))

    /** Looks through the first [size] entries of [a]. */
    public fun measure(a: DoubleArray, size: Int, loop: RangeLoop): Extremes {
        clear()
        loop.run(size, RangeLoop.GRAIN * 4) { _, from, to -> include(a, from, to) }
        return this
    }

    /** As if nothing had been looked at. */
    internal fun clear() {
        least = Double.POSITIVE_INFINITY
        greatest = Double.NEGATIVE_INFINITY
    }

    /** Looks at the entries [from] until [to] of [a] as well. Any number of threads may call. */
    internal fun include(a: DoubleArray, from: Int, to: Int) {
        var low = Double.POSITIVE_INFINITY
        var high = Double.NEGATIVE_INFINITY
        // These branches are nearly always predicted; Math.min and Math.max would depend on each other.
        for (k in from until to) {
            val v = a[k]
            if (v < low) low = v
            if (v > high) high = v
        }
        include(low, high)
    }

    /** The same for the entries of [a] less [factor] times those of [b]. */
    internal fun include(a: DoubleArray, factor: Double, b: DoubleArray, from: Int, to: Int) {
        var low = Double.POSITIVE_INFINITY
        var high = Double.NEGATIVE_INFINITY
        for (k in from until to) {
            val v = a[k] - factor * b[k]
            if (v < low) low = v
            if (v > high) high = v
        }
        include(low, high)
    }

    private fun include(low: Double, high: Double) = synchronized(this) {
        if (low < least) least = low
        if (high > greatest) greatest = high
    }
}
