package daphnis.core.population

/**
 * The arrays of a [Population], all of one length. A population has two sets of them, which take turns: a step is
 * written to one and leaves the other as it was, so that the step can be taken back by changing a reference.
 */
internal class PopulationColumns(
    override val x: DoubleArray,
    override val y: DoubleArray,
    override val z: DoubleArray,
    override val vx: DoubleArray,
    override val vy: DoubleArray,
    override val vz: DoubleArray,
    bodies: BodyColumns,
    lastCollision: DoubleArray,
) : SphereColumns {
    /** An empty set for [size] spheres, with the [lastCollision] of another set. */
    constructor(size: Int, lastCollision: DoubleArray) : this(
        DoubleArray(size),
        DoubleArray(size),
        DoubleArray(size),
        DoubleArray(size),
        DoubleArray(size),
        DoubleArray(size),
        BodyColumns(size),
        lastCollision,
    )

    /** What a step does not change: the same for both sets as long as spheres keep their order. */
    var bodies: BodyColumns = bodies
    override val radius: DoubleArray get() = bodies.radius
    override val mass: DoubleArray get() = bodies.mass
    override val id: IntArray get() = bodies.id

    /** One array for both sets as long as no step writes it. */
    override var lastCollision: DoubleArray = lastCollision
        private set

    override val size: Int get() = x.size

    /** Takes over the array of [other], for a step that does not write it. */
    fun shareLastCollision(other: PopulationColumns) {
        lastCollision = other.lastCollision
    }

    /** Ensures an array that is not that of [other], for a step that writes it. */
    fun separateLastCollision(other: PopulationColumns) {
        if (lastCollision === other.lastCollision) lastCollision = DoubleArray(size)
    }

    /** Ensures an array of the right length that is that of no other set, with no collision in it. */
    fun ownLastCollision() {
        lastCollision = DoubleArray(size) { Double.NEGATIVE_INFINITY }
    }

    /** Copies all but positions to [to], which shares our [bodies]. */
    fun copyAllButPositionsInto(to: PopulationColumns) {
        vx.copyInto(to.vx)
        vy.copyInto(to.vy)
        vz.copyInto(to.vz)
        to.shareLastCollision(this)
    }

    /** New columns of the spheres at the indices [kept]. */
    fun pick(kept: IntArray): PopulationColumns {
        fun pick(a: DoubleArray) = DoubleArray(kept.size) { a[kept[it]] }
        return PopulationColumns(
            pick(x),
            pick(y),
            pick(z),
            pick(vx),
            pick(vy),
            pick(vz),
            BodyColumns(pick(radius), pick(mass), IntArray(kept.size) { id[kept[it]] }),
            pick(lastCollision),
        )
    }

    /** New columns of these spheres and then those of [others]. */
    fun plus(others: PopulationColumns): PopulationColumns = PopulationColumns(
        x + others.x,
        y + others.y,
        z + others.z,
        vx + others.vx,
        vy + others.vy,
        vz + others.vz,
        BodyColumns(radius + others.radius, mass + others.mass, id + others.id),
        lastCollision + others.lastCollision,
    )
}

/** Radii, masses and ids of spheres. */
internal class BodyColumns(val radius: DoubleArray, val mass: DoubleArray, val id: IntArray) {
    constructor(size: Int) : this(DoubleArray(size), DoubleArray(size), IntArray(size))

    val size: Int get() = id.size
}
