package daphnis.core.search

import daphnis.core.population.Population
import kotlin.math.abs

/**
 * How far a sphere may go along each axis within a step: a bound that the search relies on, not a guess. It is the largest speed
 * along the axis times the duration, with some headroom for what collisions may add. An engine checks every velocity a
 * collision creates against it; when one exceeds it, the step is restored, [enlarge] is called and the step is redone.
 */
public class Reach {
    private val fastest = DoubleArray(AXES)
    private var headroom = LEAST_HEADROOM

    /** The bound along x, y, z, in units of length. */
    public val bound: DoubleArray = DoubleArray(AXES)

    /** Speeds along x, y, z: nobody who stays within them can outrun [bound]. */
    public val speed: DoubleArray = DoubleArray(AXES)

    /** Looks at all velocities of [population] for a step of [duration]. */
    public fun measure(population: Population, duration: Double) {
        headroom = maxOf(LEAST_HEADROOM, headroom * DECAY)
        fastest[0] = largest(population.vx)
        fastest[1] = largest(population.vy)
        fastest[2] = largest(population.vz)
        apply(duration)
    }

    /** After [speedX] … turned out larger than the bound allows: makes room for twice the excess on that axis. */
    public fun enlarge(speedX: Double, speedY: Double, speedZ: Double, duration: Double) {
        headroom *= 1.5
        raise(0, speedX)
        raise(1, speedY)
        raise(2, speedZ)
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

    private fun largest(a: DoubleArray): Double {
        var most = 0.0
        for (v in a) most = Math.max(most, abs(v))
        return most
    }

    private companion object {
        const val AXES = 3
        const val LEAST_HEADROOM = 0.05
        const val DECAY = 0.98
        const val LEAST_SHARE = 0.1
        const val ROUNDING = 1e-12
    }
}
