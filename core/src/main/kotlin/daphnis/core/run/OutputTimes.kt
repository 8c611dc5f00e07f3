package daphnis.core.run

import daphnis.core.Interval
import daphnis.core.Simulation
import daphnis.core.scenario.OutputSpec
import kotlin.math.floor

/**
 * When an output is due: every [every] steps, or with an [interval] after the first step that ends at one of its
 * multiples or later. In either case it is due at the start.
 *
 * @property every a number of steps; 0 for never, or for an interval
 * @property interval null for a number of steps
 */
public class OutputTimes internal constructor(public val every: Int, public val interval: Interval?) {
    /** Whether it is never due. */
    public val isNever: Boolean get() = every == 0 && interval == null

    /** Whether it is due after the last step of [simulation]. */
    internal fun isDue(simulation: Simulation): Boolean = when {
        interval == null -> every > 0 && simulation.step % every == 0L
        simulation.step == 0L -> true
        else -> interval.isPassed(simulation.timeBefore, simulation.time)
    }

    /** How often it is due in [course], with the first state. */
    internal fun count(course: Course): Double = when {
        interval != null -> minOf(interval.count(course.end) - interval.count(course.start), course.steps) + 1
        every == 0 -> 0.0
        else -> floor(course.steps / every) + 1
    }

    /** Whether it is due after the last step of [course]. */
    internal fun isDueAtEnd(course: Course): Boolean = when {
        interval != null -> interval.next(course.end - course.end * END) <= course.end + course.end * END
        else -> every > 0 && course.steps % every == 0.0
    }

    override fun equals(other: Any?): Boolean =
        other is OutputTimes && every == other.every && interval?.length == other.interval?.length

    override fun hashCode(): Int = every + interval?.length.hashCode()

    private companion object {
        const val END = 1e-9
    }
}

/** When a checkpoint is due; intervals of [spec] are in units of time. */
internal fun checkpointTimes(spec: OutputSpec): OutputTimes =
    spec.checkpointInterval?.let { OutputTimes(0, Interval(it)) } ?: OutputTimes(spec.checkpointEvery, null)

/**
 * The steps of a run, for what they will cost.
 *
 * @property steps how many
 * @property start time at which it starts
 * @property end time at which it ends
 */
public class Course(public val steps: Double, public val start: Double, public val end: Double)
