package daphnis.core.search

import daphnis.core.collision.StepRows
import daphnis.core.parallel.Extremes
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import kotlin.math.abs

/**
 * How far a sphere may go along each axis within a step: a bound that the search relies on, not a guess. It is the largest speed
 * along the axis times the duration, with some headroom for what collisions may add. An engine checks every velocity a
 * collision creates against it; when one exceeds it, the step is restored, [enlarge] is called and the step is redone.
 */
public class Reach {
    private val fastest = DoubleArray(AXES)
    private val extremes = Extremes()
    private var headroom = LEAST_HEADROOM

    /** The bound along x, y, z, in units of length. */
    public val bound: DoubleArray = DoubleArray(AXES)

    /** Speeds along x, y, z: nobody who stays within them can outrun [bound]. */
    public val speed: DoubleArray = DoubleArray(AXES)

    /** Looks at all velocities of [population] for a step of [duration]. */
    public fun measure(population: Population, duration: Double, loop: RangeLoop = InlineLoop) {
        headroom = maxOf(LEAST_HEADROOM, headroom * DECAY)
        fastest[0] = extremes.of(population.vx, population.size, loop).magnitude
        fastest[1] = extremes.of(population.vy, population.size, loop).magnitude
        fastest[2] = extremes.of(population.vz, population.size, loop).magnitude
        apply(duration)
    }

    /**
     * Whether sphere [slot] of [rows], if nothing more happens to it, ends the step of [duration] farther from where it started in
     * [population] than the bound. Its path so far has been asked about before.
     */
    public fun isOutrun(rows: StepRows, slot: Int, population: Population, duration: Double): Boolean {
        val state = rows.state
        val p = slot * StepRows.STRIDE
        val u = state[p + StepRows.VX]
        val v = state[p + StepRows.VX + 1]
        val w = state[p + StepRows.VX + 2]
        // Nearly always nobody is faster than the bound on speed, and where the sphere started need not be looked up.
        if (abs(u) <= speed[0] && abs(v) <= speed[1] && abs(w) <= speed[2]) return false
        val k = rows.origin[slot]
        val rest = duration - state[p + StepRows.TIME]
        return abs(state[p] + u * rest - population.x[k]) > bound[0] ||
            abs(state[p + 1] + v * rest - population.y[k]) > bound[1] ||
            abs(state[p + 2] + w * rest - population.z[k]) > bound[2]
    }

    /** After sphere [slot] of [rows] turned out to outrun the bound: makes room for twice the excess of its speed on each axis. */
    public fun enlarge(rows: StepRows, slot: Int, duration: Double) {
        val v = slot * StepRows.STRIDE + StepRows.VX
        headroom *= 1.5
        for (axis in 0 until AXES) raise(axis, abs(rows.state[v + axis]))
        apply(duration)
    }

    private fun raise(axis: Int, speed: Double) {
        if (speed > fastest[axis]) fastest[axis] += 2 * (speed - fastest[axis])
    }

    private fun apply(duration: Double) {
        // A flow without motion along an axis can gain some from the others, so no axis gets less than a little of the fastest.
        val floor = maxOf(fastest[0], fastest[1], fastest[2]) * LEAST_SHARE
        for (axis in 0 until AXES) {
            speed[axis] = maxOf(fastest[axis], floor) * (1 + headroom)
            bound[axis] = speed[axis] * duration * (1 + ROUNDING)
        }
    }

    private companion object {
        const val AXES = 3
        const val LEAST_HEADROOM = 0.05
        const val DECAY = 0.98
        const val LEAST_SHARE = 0.1
        const val ROUNDING = 1e-12
    }
}
