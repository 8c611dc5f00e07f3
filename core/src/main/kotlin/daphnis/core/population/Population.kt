package daphnis.core.population

/**
 * Spheres as a structure of arrays: entry `k` of every array belongs to the sphere with the stable id `id[k]`.
 *
 * The **index** `k` of a sphere changes from step to step, because engines keep neighbours in space next to one another in
 * memory; its **id** never does. Address a sphere across steps by id, see [indexOf]. The arrays are shared, not copied: an
 * analysis may read them between two calls of `advance()`, and a force may write the velocities. Not thread-safe; during
 * `advance()` the population belongs to the engine.
 *
 * @param x positions, in the scenario's unit of length; likewise [y], [z]
 * @param vx velocities, unit of length per unit of time; likewise [vy], [vz]
 * @param radius radii, > 0
 * @param mass masses, > 0
 * @param id distinct, non-negative; 0, 1, 2, … when not given
 * @throws IllegalArgumentException when the lengths differ, a number is not finite, a radius or mass is not positive, or an
 *   id occurs twice
 */
public class Population(
    x: DoubleArray,
    y: DoubleArray,
    z: DoubleArray,
    vx: DoubleArray,
    vy: DoubleArray,
    vz: DoubleArray,
    radius: DoubleArray,
    mass: DoubleArray,
    id: IntArray = IntArray(x.size) { it },
) {
    public var x: DoubleArray = x
        private set
    public var y: DoubleArray = y
        private set
    public var z: DoubleArray = z
        private set
    public var vx: DoubleArray = vx
        private set
    public var vy: DoubleArray = vy
        private set
    public var vz: DoubleArray = vz
        private set
    public var radius: DoubleArray = radius
        private set
    public var mass: DoubleArray = mass
        private set
    public var id: IntArray = id
        private set

    /**
     * Time since each sphere's last collision, as a negative number counted from the end of the last step, or
     * −∞ when it never collided. Kept only while a collapse guard asks for it; part of the state of a run, though not of the digest.
     */
    public var lastCollision: DoubleArray = DoubleArray(x.size) { Double.NEGATIVE_INFINITY }
        private set

    /** Number of spheres. */
    public val size: Int get() = x.size

    /** Boxes crossed by axis and id; none as long as nothing has crossed a face. */
    @Volatile
    private var crossings: Array<IntArray>? = null

    private var indexById = IntArray(0)
    private var indexIsCurrent = false

    init {
        val n = x.size
        val columns = listOf("y" to y, "z" to z, "vx" to vx, "vy" to vy, "vz" to vz, "radius" to radius, "mass" to mass)
        for ((name, column) in columns) require(column.size == n) { "$name has ${column.size} entries, x has $n" }
        require(id.size == n) { "id has ${id.size} entries, x has $n" }
        for ((name, column) in columns + ("x" to x)) {
            for (k in 0 until n) require(column[k].isFinite()) { "$name of particle ${id[k]} is ${column[k]}; it must be finite" }
        }
        for (k in 0 until n) {
            require(radius[k] > 0) { "radius of particle ${id[k]} is ${radius[k]}; it must be > 0" }
            require(mass[k] > 0) { "mass of particle ${id[k]} is ${mass[k]}; it must be > 0" }
            require(id[k] >= 0) { "id ${id[k]} is negative; ids must be >= 0" }
        }
        val sorted = id.copyOf().apply { sort() }
        for (k in 1 until n) require(sorted[k] != sorted[k - 1]) { "id ${sorted[k]} occurs twice" }
    }

    /** The index now of the sphere with the stable id [id], or −1 when there is none. Allocates nothing once warm. */
    public fun indexOf(id: Int): Int {
        if (!indexIsCurrent) indexIds()
        return if (id in indexById.indices) indexById[id] else -1
    }

    /** One more than the largest id there is; 0 for an empty population. */
    public val idBound: Int
        get() {
            if (!indexIsCurrent) indexIds()
            return indexById.size
        }

    /** To be called by whoever permuted the arrays (an engine at the end of a step). */
    public fun orderChanged() {
        indexIsCurrent = false
    }

    /**
     * Through how many boxes the sphere with the stable id [id] has gone along [axis] (0 = x, 1 = y, 2 = z), counted positive
     * upward: it stands where it would without images, less this many lengths of the box. Where images slide, the count along
     * the slide is against images that were in line at time 0 and have slid since by velocity · time, not reduced to the box.
     */
    public fun boxesCrossed(id: Int, axis: Int): Int = crossings?.get(axis)?.getOrNull(id) ?: 0

    /**
     * Adds to [boxesCrossed] of the sphere at [index], for boundaries that put it that many boxes back. Threads may do this at
     * the same time for different spheres. Part of the state of a run, though not of the digest; only spheres that cross pay.
     */
    public fun addCrossing(index: Int, axis: Int, boxes: Int) {
        val counts = crossings ?: countCrossings()
        counts[axis][id[index]] += boxes
    }

    @Synchronized
    private fun countCrossings(): Array<IntArray> = crossings ?: (id.max() + 1).let { bound -> Array(3) { IntArray(bound) } }.also { crossings = it }

    /** Keeps the spheres whose index [keep] accepts, drops the others, keeps ids. Allocates; for boundaries that remove. */
    public fun retain(keep: IndexPredicate) {
        val kept = IntArray(size)
        var n = 0
        for (k in 0 until size) if (keep.accepts(k)) kept[n++] = k
        if (n == size) return
        fun pick(a: DoubleArray) = DoubleArray(n) { a[kept[it]] }
        x = pick(x)
        y = pick(y)
        z = pick(z)
        vx = pick(vx)
        vy = pick(vy)
        vz = pick(vz)
        radius = pick(radius)
        mass = pick(mass)
        lastCollision = pick(lastCollision)
        id = id.let { old -> IntArray(n) { old[kept[it]] } }
        indexIsCurrent = false
    }

    /** A deep copy. */
    public fun copy(): Population = Population(
        x.copyOf(), y.copyOf(), z.copyOf(), vx.copyOf(), vy.copyOf(), vz.copyOf(), radius.copyOf(), mass.copyOf(), id.copyOf(),
    ).also { copy ->
        lastCollision.copyInto(copy.lastCollision)
        copy.crossings = crossings?.let { counts -> Array(3) { counts[it].copyOf() } }
    }

    private fun indexIds() {
        var bound = 0
        for (k in 0 until size) bound = maxOf(bound, id[k] + 1)
        if (indexById.size != bound) indexById = IntArray(bound)
        indexById.fill(-1)
        for (k in 0 until size) indexById[id[k]] = k
        indexIsCurrent = true
    }
}

/** Says yes or no to an index of a [Population]. */
public fun interface IndexPredicate {
    public fun accepts(index: Int): Boolean
}
