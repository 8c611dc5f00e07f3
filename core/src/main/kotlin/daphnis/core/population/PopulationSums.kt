package daphnis.core.population

import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.ChunkSums.Companion.ALL_MASS
import daphnis.core.population.ChunkSums.Companion.BODIES
import daphnis.core.population.ChunkSums.Companion.ENERGY
import daphnis.core.population.ChunkSums.Companion.MOMENTUM
import daphnis.core.population.ChunkSums.Companion.PARTICLES
import daphnis.core.population.ChunkSums.Companion.RELATIVE
import daphnis.core.population.ChunkSums.Companion.SLABS
import daphnis.core.population.ChunkSums.Companion.SLOPES
import daphnis.core.population.ChunkSums.Companion.SQUARES
import daphnis.core.population.ChunkSums.Companion.SQUARE_ACROSS
import daphnis.core.population.ChunkSums.Companion.SQUARE_Z
import daphnis.core.population.ChunkSums.Companion.SUMS
import daphnis.core.population.ChunkSums.Companion.SUM_X
import daphnis.core.population.ChunkSums.Companion.SUM_Z
import kotlin.math.sqrt

/**
 * What a row of `series.csv` and of `transport.csv` says of a population: mass, momentum, energy, and the moments of
 * its velocities. Made once and filled by [take] for each row; allocates nothing once warm. One thread calls; the loop
 * given to [take] may use more.
 *
 * Sums are taken over fixed chunks of ids and the chunks added in their order: the same to the last bit for every order
 * of the arrays, engine and number of threads.
 *
 * @param flow the mean flow that the boundary drives, or null
 * @param omega angular speed of Hill's frame, or null
 * @param firstBody spheres with ids from this on are bodies, such as moonlets: they count for mass, momentum and
 *   energy, and for nothing else; [Int.MAX_VALUE] for none
 */
public class PopulationSums(
    flow: MeanFlow?,
    private val omega: Double? = null,
    private val firstBody: Int = Int.MAX_VALUE,
) {
    private val table = IdRows()
    private val chunks = ChunkSums(table, flow)
    private val fit = FlowFit(flow?.flowAxis ?: -1)
    private val normalAxis = flow?.normalAxis ?: 0
    private val sums = DoubleArray(SUMS)
    private val sumChunks = RangeBody { _, from, to -> for (chunk in from until to) chunks.take(chunk) }

    /** Number of spheres, bodies included. */
    public var count: Int = 0
        private set

    /** Σ m of particles and bodies. */
    public val mass: Double get() = sums[PARTICLES + ALL_MASS] + sums[BODIES + ALL_MASS]

    /** Σ m v²/2 of particles and bodies. */
    public val kineticEnergy: Double get() = sums[PARTICLES + ENERGY] + sums[BODIES + ENERGY]

    /** Σ m v along [axis] of particles and bodies. */
    public fun momentum(axis: Int): Double = sums[PARTICLES + MOMENTUM + axis] + sums[BODIES + MOMENTUM + axis]

    /** Σ m of the particles. */
    public val particleMass: Double get() = sums[PARTICLES + ALL_MASS]

    /**
     * ⟨c_a c_b⟩ in (length/time)²: xx, yy, zz, xy, xz, yz; c is the peculiar velocity, what is left of the velocity
     * without the mean flow as it is measured. Weighted by mass, without bias by the number of spheres
     * ([granularTemperature] has the definition). Valid until the next [take].
     */
    public val moments: DoubleArray get() = fit.moments

    /**
     * ⟨w_a w_b⟩ likewise, w the velocity without the straight flow of the boundary's rate and without the mean: times
     * mass and over volume the kinetic part of the pressure tensor, which the energy balance of a shear flow needs.
     * Plain sums. Valid until the next [take].
     */
    public val kinetic: DoubleArray = DoubleArray(6)

    /** ⟨velocity − the boundary's flow⟩ along x, y, z; valid until the next [take]. */
    public val mean: DoubleArray = DoubleArray(3)

    /** Granular temperature ⟨c²⟩/3, (length/time)². 0 for fewer than two particles. */
    public val granularTemperature: Double get() = (fit.moments[0] + fit.moments[1] + fit.moments[2]) / 3

    /** Mean height of the particles. */
    public var centreZ: Double = 0.0
        private set

    /** √⟨(z − centre)²⟩. */
    public var scaleHeight: Double = 0.0
        private set

    /** Σ m X / Σ m, X = 4x + 2 v_y/Ω, in Hill's frame; else the mean of x. */
    public var guidingX: Double = 0.0
        private set

    /** Takes the sums of [population] as it stands, by the threads of [loop]. All are 0 for an empty one. */
    public fun take(population: Population, loop: RangeLoop = InlineLoop) {
        count = population.size
        table.gather(population, normalAxis, loop)
        chunks.prepare(table.from(firstBody), count)
        loop.run(chunks.count, 1, sumChunks)
        sums.fill(0.0)
        for (chunk in 0 until chunks.count) for (e in 0 until SUMS) sums[e] += chunks.sums[chunk * SUMS + e]
        finish()
    }

    /** From sums against the first particle to moments around the means. */
    private fun finish() {
        val mass = particleMass
        val over = if (mass > 0) 1 / mass else 0.0
        val meanZ = sums[SUM_Z] * over
        val x = chunks.origin[0] + sums[SUM_X] * over
        for (axis in 0..2) mean[axis] = if (mass > 0) chunks.reference[axis] + sums[RELATIVE + axis] * over else 0.0
        for (e in 0 until 6) {
            val ofMeans = sums[RELATIVE + FlowFit.FIRST[e]] * sums[RELATIVE + FlowFit.SECOND[e]] * over
            fit.squares[e] = sums[SQUARES + e] - ofMeans
            kinetic[e] = fit.squares[e] * over
        }
        fitFlow(mass, over)
        centreZ = chunks.origin[2] + meanZ
        scaleHeight = sqrt(maxOf(0.0, sums[SQUARE_Z] * over - meanZ * meanZ))
        guidingX = if (omega != null) 4 * x + 2 * sums[PARTICLES + MOMENTUM + 1] * over / omega else x
    }

    private fun fitFlow(mass: Double, over: Double) {
        var across = 0.0
        for (slab in 0 until chunks.slabCount) across += sums[SLABS + slab * FlowFit.SLAB_WIDTH + 1]
        fit.across = sums[SQUARE_ACROSS] - across * across * over
        for (axis in 0..2) fit.slopes[axis] = sums[SLOPES + axis] - across * sums[RELATIVE + axis] * over
        for (slab in 0 until chunks.slabCount) {
            val s = slab * FlowFit.SLAB_WIDTH
            val slabMass = sums[SLABS + s]
            fit.slabs[s] = slabMass
            fit.slabs[s + 1] = sums[SLABS + s + 1] - slabMass * across * over
            for (axis in 0..2) {
                fit.slabs[s + 2 + axis] = sums[SLABS + s + 2 + axis] - slabMass * sums[RELATIVE + axis] * over
            }
        }
        fit.solve(sums[PARTICLES].toInt(), mass, chunks.slabCount)
    }
}
