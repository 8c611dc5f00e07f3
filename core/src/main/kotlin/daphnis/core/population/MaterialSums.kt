package daphnis.core.population

import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.space.Space

/**
 * Partial temperatures of a population whose spheres have materials, from exact sums ([ExactSum]), so that they are the
 * same to the last bit for every order of the arrays. Made once and filled by [take].
 *
 * @property materials names by number, see [Population.materials]
 * @param flow the mean flow that the boundary drives, or null
 * @param firstBody spheres with this id or a higher one are left out, such as moonlets; [Int.MAX_VALUE] for none
 * @param space in which spheres move
 */
public class MaterialSums @JvmOverloads constructor(
    public val materials: List<String>,
    flow: MeanFlow? = null,
    private val firstBody: Int = Int.MAX_VALUE,
    private val space: Space = Space.VOLUME,
) {
    private val normalAxis = flow?.normalAxis ?: 0
    internal val parts = PartialSums(2 * materials.size) { from, to, into, _ -> add(from, to, into) }
    private val mean = DoubleArray(AXES)
    private val gradient = DoubleArray(AXES)
    private var population: Population? = null

    /** Number of spheres of the material of [number]. */
    public fun count(number: Int): Long = parts.value(materials.size + number).toLong()

    /**
     * T = ⟨m c²⟩/3, in the plane ⟨m c²⟩/2, of the spheres of the material of [number], an energy: c is the velocity
     * without the boundary's flow and without the mean of all materials, weighted by mass (Garzó & Dufty 1999, Phys.
     * Rev. E 60, 5706). No correction for degrees of freedom. NaN without spheres.
     */
    public fun temperature(number: Int): Double {
        val count = parts.value(materials.size + number)
        return if (count > 0) parts.value(number) / count / space.dimensions else Double.NaN
    }

    /**
     * Takes the sums of the present state of [population] on the threads of [loop].
     *
     * @param sums of the same state
     */
    @JvmOverloads
    public fun take(population: Population, sums: PopulationSums, loop: RangeLoop = InlineLoop): Unit =
        take(population, sums.means, loop)

    internal fun take(population: Population, means: Means, loop: RangeLoop) {
        means.velocity.copyInto(mean)
        means.gradient.copyInto(gradient)
        this.population = population
        try {
            parts.take(if (population.hasMaterials) population.size else 0, loop)
        } finally {
            this.population = null
        }
    }

    private fun add(from: Int, to: Int, into: Array<ExactSum>) {
        val p = population!!
        for (k in from until to) {
            if (p.id[k] >= firstBody) continue
            var square = 0.0
            for (axis in 0 until AXES) {
                var c = p.velocity(axis)[k] - mean[axis]
                if (gradient[axis] != 0.0) c -= gradient[axis] * p.position(normalAxis)[k]
                square += c * c
            }
            val number = p.material[k].toInt()
            into[number].add(p.mass[k] * square)
            into[materials.size + number].add(1.0)
        }
    }

    private companion object {
        const val AXES = 3
    }
}
