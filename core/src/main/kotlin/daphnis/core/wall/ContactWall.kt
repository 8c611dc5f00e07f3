package daphnis.core.wall

import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.StepRows

/**
 * A [Wall] within a step, as spheres see it whose paths are straight. Threads share it: all but [begin] and [spread] is
 * a pure function of the sphere's row and the step.
 */
internal interface ContactWall {
    /** A step of [duration] begins at [start]. */
    fun begin(start: Double, duration: Double)

    /** See [WallContact.time]. */
    fun time(rows: StepRows, slot: Int): Double

    /** Reflects sphere [slot], which has been advanced to [time]; what happened is described in [outcome]. */
    fun reflect(rows: StepRows, slot: Int, time: Double, outcome: CollisionOutcome)

    /** From now on [soonest] is asked about the time [span] from the start of this step. */
    fun spread(span: Double)

    /**
     * How long a sphere of radius [r] which keeps to a line, now at ([x], [y], [z]), surely does not touch;
     * [daphnis.core.collision.NEVER] when it cannot at all. See [spread].
     */
    fun soonest(x: Double, y: Double, z: Double, vx: Double, vy: Double, vz: Double, r: Double): Double
}
