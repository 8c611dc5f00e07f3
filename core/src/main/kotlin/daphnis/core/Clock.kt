package daphnis.core

/**
 * Times of a run with fixed steps, counted from [start] so that no round-off accumulates. A run that goes on from a
 * state of another keeps the other's clock: then the same step has the same time in both, to the bit.
 *
 * @property start time from which steps are counted
 * @property steps that lie between [start] and step 0 of the run
 */
public class Clock @JvmOverloads constructor(public val start: Double, public val steps: Long = 0) {
    /** Time after [step] steps of [duration]. */
    public fun time(step: Long, duration: Double): Double = start + (steps + step) * duration
}
