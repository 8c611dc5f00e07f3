package daphnis.core.population

/**
 * Spheres as a structure of arrays: the first [size] entries of each array count, and entry `k` of all arrays belongs
 * to one sphere. Arrays may be longer than that. A [Population] is all spheres of a simulation. An engine may copy some
 * of them into columns of its own, where the neighbour search looks at them in the same way.
 */
public interface SphereColumns {
    /** Number of spheres. */
    public val size: Int

    /** Stable ids, distinct. */
    public val id: IntArray

    /** Number of columns of numbers. */
    public val columnCount: Int get() = SphereQuantity.WIDTH

    /**
     * The column at [place]: 0, 1, 2 positions, 3, 4, 5 velocities, 6 radii, 7 masses, 8, 9, 10 angular velocities,
     * 11 materials, then what else is known. It is empty where spheres do not have what it is of.
     */
    public fun column(place: Int): DoubleArray

    /** Positions, in the scenario's unit of length; likewise [y], [z]. */
    public val x: DoubleArray get() = column(0)
    public val y: DoubleArray get() = column(1)
    public val z: DoubleArray get() = column(2)

    /** Velocities, unit of length per unit of time; likewise [vy], [vz]. */
    public val vx: DoubleArray get() = column(3)
    public val vy: DoubleArray get() = column(4)
    public val vz: DoubleArray get() = column(5)

    /** Radii, > 0. */
    public val radius: DoubleArray get() = column(6)

    /** Masses, > 0. */
    public val mass: DoubleArray get() = column(7)

    /**
     * Whether spheres have angular velocities, which only rough ones need. All of a population have them or none.
     */
    public val hasSpin: Boolean get() = column(SPIN) !== SphereQuantity.NONE

    /**
     * Angular velocities, radians per unit of time, in Hill's frame relative to the frame; likewise [wy], [wz]. Empty
     * unless [hasSpin].
     */
    public val wx: DoubleArray get() = column(SPIN)
    public val wy: DoubleArray get() = column(SPIN + 1)
    public val wz: DoubleArray get() = column(SPIN + 2)

    /** Whether it is known what spheres are made of. All of a population have a material or none. */
    public val hasMaterials: Boolean get() = column(MATERIAL) !== SphereQuantity.NONE

    /** Numbers 0, 1, 2, … of materials, see [Population.materials], which no step changes. Empty unless [hasMaterials]. */
    public val material: DoubleArray get() = column(MATERIAL)

    /**
     * Partners of each sphere, by ascending id, each followed by the state of the pair: `[id, state, id, state, …]`, see
     * [daphnis.core.potential.PairInteraction]. Not to be changed. Empty where pairs remember nothing.
     */
    public val bonds: Array<IntArray> get() = Bonds.NONE

    /** See [Population.lastCollision]. */
    public val lastCollision: DoubleArray get() = column(SphereQuantity.LAST_COLLISION.place)

    /** Positions along [axis]: 0 = x, 1 = y, 2 = z. */
    public fun position(axis: Int): DoubleArray = column(axis)

    /** Velocities along [axis]. */
    public fun velocity(axis: Int): DoubleArray = column(3 + axis)
}

/** The set of optional quantities that the spheres have, see [SphereQuantity.of]. */
internal val SphereColumns.optional: Int get() = SphereQuantity.of(this)

private val SPIN = SphereQuantity.SPIN.place
private val MATERIAL = SphereQuantity.MATERIAL.place
