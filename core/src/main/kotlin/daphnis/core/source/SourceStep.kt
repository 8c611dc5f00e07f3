package daphnis.core.source

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.prepare
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereQuantity
import daphnis.core.population.nextId
import daphnis.core.population.optional
import daphnis.core.space.Images
import java.util.function.IntPredicate
import kotlin.math.abs
import kotlin.math.floor

/** One source at the end of one step: what it sees of the spheres, and how it brings and takes them. */
internal class SourceStep(
    private val number: Int,
    val population: Population,
    private val partition: Partition,
    private val boundary: BoundaryConditions,
    private val end: Double,
    val duration: Double,
    private val inertia: Double,
    val random: SeededRandom,
    private val sums: SourceSums,
) {
    private val images = Images().also { it.prepare(boundary, end) }
    private val walls = boundary.walls.toList()
    val space get() = boundary.space

    /** Standard deviation of each component of the spin of a [sphere] in a gas of [temperature]. */
    fun spinSpread(sphere: Newcomer, temperature: Double): Double =
        if (population.hasSpin) Math.sqrt(temperature / (inertia * sphere.mass)) / sphere.radius else 0.0

    /** Takes away the spheres of which [leaves] says so, by index. */
    fun remove(leaves: IntPredicate) {
        for (k in 0 until population.size) if (leaves.test(k)) sums.add(number, population, k, -1.0, inertia)
        population.retain { !leaves.test(it) }
    }

    /** So many [spheres] found no place. */
    fun refuse(spheres: Int) {
        if (partition.isFirst) sums.refuse(number, spheres)
    }

    /** Brings [spheres], in this order, which are in the box. All nodes bring the same. */
    fun add(spheres: List<Newcomer>) {
        if (spheres.isEmpty()) return
        val next = partition.nextId(population, spheres.size.toLong())
        val own = if (partition.isFirst) spheres else emptyList()
        val columns = PopulationColumns(own.size, population.optional)
        columns.lastCollision.fill(SphereQuantity.LAST_COLLISION.absent)
        for ((k, sphere) in own.withIndex()) {
            columns.id[k] = next + k
            columns.radius[k] = sphere.radius
            columns.mass[k] = sphere.mass
            if (columns.hasMaterials) columns.material[k] = sphere.material.toDouble()
            for (axis in 0 until AXES) {
                columns.position(axis)[k] = sphere.position[axis]
                columns.velocity(axis)[k] = sphere.velocity[axis]
                if (population.hasSpin) columns.column(SphereQuantity.SPIN.place + axis)[k] = sphere.spin[axis]
            }
        }
        val before = population.size
        population.join(columns, IntArray(spheres.size) { next + it })
        for (k in before until population.size) sums.add(number, population, k, 1.0, inertia)
    }

    /** Brings a [sphere] that has gone beyond faces which repeat back into the box. */
    fun wrap(sphere: Newcomer) {
        for (axis in 0 until AXES) {
            val length = images.period(axis)
            if (length == 0.0) continue
            val lower = boundary.box.lower(axis)
            val x = sphere.position[axis]
            val wrapped = x - length * floor((x - lower) / length)
            sphere.position[axis] = if (wrapped < lower || wrapped >= boundary.box.upper(axis)) lower else wrapped
        }
    }

    /** Where the centre of a sphere of [radius] is that has just come through the face of this [number]. */
    fun face(number: Int, radius: Double): Double {
        val axis = number shr 1
        val inside = if (boundary.contactFaces(axis) == ContactFaces.WALL) radius else 0.0
        return if (number and 1 == 0) boundary.box.lower(axis) + inside else boundary.box.upper(axis) - inside
    }

    /** Whether a sphere of [radius] at [at] is inside of all walls. */
    fun isInRoom(at: DoubleArray, radius: Double): Boolean =
        walls.all { it.distance(at[0], at[1], at[2], end) >= radius }

    /**
     * All spheres, of any node, that a sphere with a radius of [largest] or less may overlap whose centre is between
     * [lower] and [upper], in the order of ids. The same on all nodes.
     *
     * @param isOwn marks spheres, by index
     */
    fun near(lower: DoubleArray, upper: DoubleArray, largest: Double, isOwn: IntPredicate? = null): Neighbourhood {
        val p = population
        val seen = IntArray(p.size)
        var count = 0
        for (k in 0 until p.size) if (isNear(k, lower, upper, largest)) seen[count++] = k
        val message = IntArray(count * ENTRY)
        for (n in 0 until count) {
            val k = seen[n]
            val at = n * ENTRY
            message[at] = p.id[k]
            message[at + 1] = if (isOwn?.test(k) == true) 1 else 0
            for (axis in 0 until AXES) put(p.position(axis)[k], message, at + 2 + 2 * axis)
            put(p.radius[k], message, at + 2 + 2 * AXES)
        }
        val all = partition.gather(message)
        val order = (0 until all.size / ENTRY).sortedBy { all[it * ENTRY] }
        val widest = maxOf(largest, order.maxOfOrNull { get(all, it * ENTRY + 2 + 2 * AXES) } ?: 0.0)
        val spheres = Neighbourhood(lower, upper, largest + widest, order.size, images, boundary.box)
        for (n in order) {
            val at = n * ENTRY
            val place = DoubleArray(AXES) { get(all, at + 2 + 2 * it) }
            spheres.add(all[at], place, get(all, at + 2 + 2 * AXES), all[at + 1] == 1)
        }
        return spheres
    }

    private fun isNear(k: Int, lower: DoubleArray, upper: DoubleArray, largest: Double): Boolean {
        val reach = (largest + population.radius[k]) * SLIGHTLY_MORE
        for (axis in 0 until AXES) {
            val half = (upper[axis] - lower[axis]) / 2
            val d = population.position(axis)[k] - (lower[axis] + half)
            val length = images.period(axis)
            val apart = if (length > 0) d - Math.rint(d / length) * length else d
            if (abs(apart) > half + reach) return false
        }
        return true
    }

    private fun put(number: Double, into: IntArray, at: Int) {
        val bits = number.toRawBits()
        into[at] = (bits ushr Int.SIZE_BITS).toInt()
        into[at + 1] = bits.toInt()
    }

    private fun get(from: IntArray, at: Int): Double =
        Double.fromBits(from[at].toLong() shl Int.SIZE_BITS or (from[at + 1].toLong() and WORD))

    private companion object {
        const val AXES = 3

        /** Id, mark, and two words each for x, y, z and the radius. */
        const val ENTRY = 10
        const val WORD = 0xffffffffL

        /** Than any rounding of distances. */
        const val SLIGHTLY_MORE = 1 + 1e-9
    }
}
