package daphnis.core

import kotlin.math.abs

/**
 * Times at which a step has to end: the multiples of [intervals], and [end].
 *
 * Between them, steps have one of few lengths: the shortest interval halved as often as needed, or without an interval
 * a power of two. So steps are equal to the last bit for as long as can be, which engines that search for several steps
 * at once rely on, and a step that meets no other interval hits the next stop without a rest. Everything here depends
 * on the time and the wanted length only, so a resumed run makes the same steps.
 *
 * @param end a time, or infinity for none
 */
public class Stops @JvmOverloads constructor(intervals: List<Interval>, end: Double = Double.POSITIVE_INFINITY) {
    public val intervals: List<Interval> = intervals.toList()
    private val shortest = intervals.minOfOrNull { it.length }

    /** A time, or infinity for none. The thread that advances may set another between two steps. */
    public var end: Double = checked(end)
        set(value) {
            field = checked(value)
        }

    /** The first stop after [time]; infinity when there is none. */
    public fun next(time: Double): Double {
        var stop = Double.POSITIVE_INFINITY
        for (interval in intervals) stop = minOf(stop, interval.next(time))
        val isAhead = end > time + Interval.ROUNDING * abs(time)
        return if (isAhead && end <= stop + Interval.ROUNDING * abs(stop)) end else stop
    }

    /**
     * Length of the step that begins at [start] and shall last at most [longest].
     *
     * @throws IllegalStateException when it would be lost in the rounding of the time
     */
    public fun duration(start: Double, longest: Double): Double {
        val whole = whole(longest)
        val room = next(start) - start
        val duration = if (room < whole - slack(start, start + whole)) room else whole
        check(start + duration > start) { "a step of $duration is lost in the rounding of the time, $start" }
        return duration
    }

    /**
     * End of the step that begins at [start] and lasts [duration], as the function gave it: a stop to the bit, or a
     * whole number of such steps before it, so that round-off does not grow.
     */
    public fun timeAfter(start: Double, duration: Double): Double {
        val stop = next(start)
        val end = start + duration
        val steps = Math.rint((stop - end) / duration)
        val even = stop - steps * duration
        return if (abs(even - end) <= 2 * slack(start, end)) even else end
    }

    private fun checked(end: Double): Double {
        require(!end.isNaN()) { "the end is NaN" }
        return end
    }

    /** How much a time may be off by round-off in a step from [start] to [end]: near time 0, as much as [start] is. */
    private fun slack(start: Double, end: Double) = 4 * Math.ulp(maxOf(abs(start), abs(end)))

    private fun whole(longest: Double): Double {
        if (shortest == null) return Math.scalb(1.0, Math.getExponent(longest))
        if (longest >= shortest) return shortest
        val halved = Math.scalb(shortest, Math.getExponent(longest) - Math.getExponent(shortest))
        return if (halved <= longest) halved else halved / 2
    }
}

/** A [TimeStep] whose steps end at given times: [next] gives the most that a step may last. */
public interface StoppingTimeStep : TimeStep {
    public val stops: Stops
}
