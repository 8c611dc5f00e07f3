package daphnis.core

import kotlin.math.abs
import kotlin.math.floor

/**
 * The multiples of [length], in units of time, counted from time 0.
 *
 * A time that misses a multiple by round-off, 1e-12 of the time, is that multiple. So the times of runs that start
 * anywhere, and of intervals that share a multiple, agree.
 */
public class Interval(public val length: Double) {
    init {
        require(length > 0 && length.isFinite()) { "an interval is $length; it must be > 0" }
    }

    /** How many multiples after 0 the last one is that is not later than [time]. */
    public fun count(time: Double): Double = count(time, abs(time))

    /** The first multiple after [time]. */
    public fun next(time: Double): Double = (count(time) + 1) * length

    /** Whether a multiple is later than [before] and not later than [time]. */
    public fun isPassed(before: Double, time: Double): Boolean {
        if (before >= 0) return count(time) > count(before)
        // A step that comes to time 0 from below misses it by the round-off of where it began.
        val scale = maxOf(-before, abs(time))
        return count(time, scale) > count(before, scale)
    }

    private fun count(time: Double, scale: Double) = floor((time + ROUNDING * scale) / length)

    public companion object {
        /** Times closer together than this part of them are one. */
        internal const val ROUNDING: Double = 1e-12

        /** A time can be this many intervals; beyond, multiples would come near their round-off. */
        public const val MOST: Double = 1e9
    }
}
