package daphnis.core.population

import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.space.Space
import daphnis.core.surface.SurfaceContact

/**
 * Sums over the spins of a population, exact ([ExactSum]), so that they are the same to the last bit for every order of
 * the arrays. Made once and filled by [take]. All are 0 for spheres without spins.
 *
 * @param momentFactor moment of inertia of spheres over mass · radius²
 * @param space in which spheres move: in the plane they spin about z alone
 */
public class SpinSums @JvmOverloads constructor(
    private val momentFactor: Double = SurfaceContact.SOLID,
    private val space: Space = Space.VOLUME,
) {
    internal val parts = PartialSums(SUMS) { from, to, into, block -> add(from, to, into, block) }
    private var population: Population? = null

    /** Σ I ω²/2. */
    public val energyOfRotation: Double get() = parts.value(ENERGY) / 2

    /**
     * ⟨I ω²⟩/3, in the plane ⟨I ω²⟩, over the mean mass, (length/time)²: comparable with the granular temperature
     * ⟨c²⟩/3. The mean spin is not taken off. 0 without spheres.
     */
    public val temperature: Double
        get() = parts.value(MASS).let { if (it > 0) parts.value(ENERGY) / it / space.rotations else 0.0 }

    /** Mean of ω along [axis] over all spheres. */
    public fun mean(axis: Int): Double = parts.value(COUNT).let { if (it > 0) parts.value(SPINS + axis) / it else 0.0 }

    /**
     * Σ (m **r** × **v** + I **ω**) along [axis], about the origin. It means something only where space neither repeats
     * nor turns.
     */
    public fun angularMomentum(axis: Int): Double = parts.value(MOMENTA + axis)

    /** Takes the sums of the present state of [population] on the threads of [loop]. */
    @JvmOverloads
    public fun take(population: Population, loop: RangeLoop = InlineLoop) {
        this.population = population
        try {
            parts.take(if (population.hasSpin) population.size else 0, loop)
        } finally {
            this.population = null
        }
    }

    private fun add(from: Int, to: Int, into: Array<ExactSum>, block: SphereSum) {
        val p = population!!
        val mass = p.mass
        val radius = p.radius
        block.addBlocks(from, to, into[MASS]) { start, end, terms -> mass.copyInto(terms, 0, start, end) }
        block.addBlocks(from, to, into[COUNT]) { start, end, terms -> terms.fill(1.0, 0, end - start) }
        block.addBlocks(from, to, into[ENERGY]) { start, end, terms ->
            for (k in start until end) {
                val square = p.wx[k] * p.wx[k] + p.wy[k] * p.wy[k] + p.wz[k] * p.wz[k]
                terms[k - start] = momentFactor * mass[k] * radius[k] * radius[k] * square
            }
        }
        for (axis in 0 until AXES) {
            val spin = p.column(SPIN + axis)
            block.addBlocks(from, to, into[SPINS + axis]) { start, end, terms -> spin.copyInto(terms, 0, start, end) }
            val momentum = into[MOMENTA + axis]
            block.addBlocks(from, to, momentum) { start, end, terms ->
                for (k in start until end) terms[k - start] = momentFactor * mass[k] * radius[k] * radius[k] * spin[k]
            }
            val a = (axis + 1) % AXES
            val b = (axis + 2) % AXES
            addMoments(from, to, momentum, block, mass, p.position(a), p.velocity(b))
            addMoments(from, to, momentum, block, mass, p.position(b), p.velocity(a), sign = -1.0)
        }
    }

    /** Adds Σ ± m x v. */
    private fun addMoments(
        from: Int,
        to: Int,
        into: ExactSum,
        block: SphereSum,
        mass: DoubleArray,
        x: DoubleArray,
        v: DoubleArray,
        sign: Double = 1.0,
    ) = block.addBlocks(from, to, into) { start, end, terms ->
        for (k in start until end) terms[k - start] = sign * mass[k] * (x[k] * v[k])
    }

    private companion object {
        private const val AXES = 3
        private const val ENERGY = 0
        private const val MASS = 1
        private const val COUNT = 2
        private const val SPINS = 3
        private const val MOMENTA = SPINS + AXES
        private const val SUMS = MOMENTA + AXES
        private val SPIN = SphereQuantity.SPIN.place
    }
}
