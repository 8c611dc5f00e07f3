package daphnis.core.population

/**
 * Spheres as a structure of arrays: the first [size] entries of each array count, and entry `k` of all arrays belongs
 * to one sphere. Arrays may be longer than that. A [Population] is all spheres of a simulation. An engine may copy some
 * of them into columns of its own, where the neighbour search looks at them in the same way.
 */
public interface SphereColumns {
    /** Number of spheres. */
    public val size: Int

    /** Positions, in the scenario's unit of length; likewise [y], [z]. */
    public val x: DoubleArray
    public val y: DoubleArray
    public val z: DoubleArray

    /** Velocities, unit of length per unit of time; likewise [vy], [vz]. */
    public val vx: DoubleArray
    public val vy: DoubleArray
    public val vz: DoubleArray

    /** Radii, > 0. */
    public val radius: DoubleArray

    /** Masses, > 0. */
    public val mass: DoubleArray

    /** Stable ids, distinct. */
    public val id: IntArray

    /** See [Population.lastCollision]. */
    public val lastCollision: DoubleArray

    /** Positions along [axis]: 0 = x, 1 = y, 2 = z. */
    public fun position(axis: Int): DoubleArray = when (axis) {
        0 -> x
        1 -> y
        else -> z
    }

    /** Velocities along [axis]. */
    public fun velocity(axis: Int): DoubleArray = when (axis) {
        0 -> vx
        1 -> vy
        else -> vz
    }
}
