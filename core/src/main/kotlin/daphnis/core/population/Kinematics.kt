package daphnis.core.population

import daphnis.core.space.Space

/** What sums over velocities have to know of where spheres move. */
public interface Kinematics {
    /** Space in which they move. */
    public val space: Space

    /** The mean flow that is driven, or null when there is none. A granular temperature excludes it. */
    public val meanFlow: MeanFlow?
}

/**
 * A mean flow along [flowAxis] that changes with the position along [normalAxis] (0 = x, 1 = y, 2 = z), by [rate] per
 * unit of length where it is uniform: v_x = γ y in Lees–Edwards boxes, v_y = −(3/2) Ω x in Hill's frame.
 *
 * @property spread by which the flow along [normalAxis] itself changes with the position along it, per unit of time: 0
 *   unless the box widens and narrows
 */
public class MeanFlow @JvmOverloads constructor(
    public val normalAxis: Int,
    public val flowAxis: Int,
    public val rate: Double,
    public val spread: Double = 0.0,
) {
    /** By how much the flow along [axis] changes with the position along [normalAxis], per unit of time. */
    public fun gradient(axis: Int): Double = when (axis) {
        flowAxis -> rate
        normalAxis -> spread
        else -> 0.0
    }
}
