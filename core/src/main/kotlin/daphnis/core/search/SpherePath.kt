package daphnis.core.search

import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.VX

/**
 * The straight path of a sphere for which [CellRuns] searches: where it is, and how far it goes along x, y, z until the
 * end of the step. Set anew for each search.
 */
public class SpherePath internal constructor() {
    internal val from = DoubleArray(3)
    internal val way = DoubleArray(3)
    internal var radius = 0.0
        private set

    /** The path of a sphere of [radius] that stays at ([x], [y], [z]). */
    public fun set(x: Double, y: Double, z: Double, radius: Double) {
        from[0] = x
        from[1] = y
        from[2] = z
        way.fill(0.0)
        this.radius = radius
    }

    /** The path of the sphere in the row at [p] of [state], which goes on for the time [rest]. */
    internal fun set(state: DoubleArray, p: Int, rest: Double) {
        for (axis in 0..2) {
            from[axis] = state[p + axis]
            way[axis] = state[p + VX + axis] * rest
        }
        radius = state[p + RADIUS]
    }

    /** The same for numbers of one's own; for tests. */
    internal fun set(from: DoubleArray, way: DoubleArray, radius: Double) {
        from.copyInto(this.from)
        way.copyInto(this.way)
        this.radius = radius
    }
}
