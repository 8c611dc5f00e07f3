package daphnis.core.population

import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop
import kotlin.math.sqrt

/**
 * The numbers on a population in a row of `series.csv` and of `transport.csv`: mass, momentum, energy, and the moments
 * of its velocities. Made once and filled by [take] for each row; allocates nothing once warm. One thread calls; the
 * loop given to [take] may use more.
 *
 * Sums are exact ([ExactSum]), first those of [FirstMoments] and then those of [CentralMoments] around the means from
 * the first. So they are the same to the last bit for every order of the arrays, engine and number of threads.
 *
 * @param flow the mean flow that the boundary drives, or null
 * @param omega angular speed of Hill's frame, or null
 * @param firstBody spheres with this id or a higher one are bodies, such as moonlets: they contribute to mass, momentum
 *   and energy, and to nothing else; [Int.MAX_VALUE] for none
 */
public class PopulationSums @JvmOverloads constructor(
    flow: MeanFlow?,
    private val omega: Double? = null,
    private val firstBody: Int = Int.MAX_VALUE,
) {
    private val flowAxis = flow?.flowAxis ?: -1
    private val normalAxis = flow?.normalAxis ?: 0
    private val rate = flow?.rate ?: 0.0
    private val fit = FlowFit(flowAxis)
    private val means = Means()

    // One of each per worker of the loop, merged into the first.
    private val first = Workers { FirstMoments(normalAxis, firstBody) }
    private val central = Workers { CentralMoments(flow, firstBody) }
    private var population: Population? = null
    private val takeFirst = RangeBody { worker, from, to -> first[worker].add(population!!, from, to) }
    private val takeCentral = RangeBody { worker, from, to -> central[worker].add(population!!, from, to) }

    /** Number of spheres, including bodies. */
    public var count: Int = 0
        private set

    /** Σ m of particles and bodies. */
    public val mass: Double get() = first[0].mass

    /** Σ m v²/2 of particles and bodies. */
    public val kineticEnergy: Double get() = first[0].kineticEnergy

    /** Σ m v along [axis] of particles and bodies. */
    public fun momentum(axis: Int): Double = first[0].momentum(axis)

    /** Σ m of the particles. */
    public val particleMass: Double get() = first[0].particleMass

    /**
     * ⟨c_a c_b⟩ in (length/time)²: xx, yy, zz, xy, xz, yz; c is the peculiar velocity, which is the velocity minus the
     * measured mean flow. Weighted by mass, without bias from the number of spheres ([granularTemperature] has the
     * definition). Valid until the next [take].
     */
    public val moments: DoubleArray get() = fit.moments

    /**
     * ⟨w_a w_b⟩ in the same order, where w is the velocity without the straight flow at the boundary's rate and without
     * the mean. Times mass over volume it is the kinetic part of the pressure tensor, which the energy balance of a
     * shear flow needs. There is no correction for degrees of freedom. Valid until the next [take].
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

    /** Σ m X / Σ m with X = 4x + 2 v_y/Ω in Hill's frame; otherwise the mean of x. */
    public var guidingX: Double = 0.0
        private set

    /** Takes the sums of the present state of [population] on the threads of [loop]. All are 0 for an empty one. */
    @JvmOverloads
    public fun take(population: Population, loop: RangeLoop = InlineLoop) {
        count = population.size
        this.population = population
        first.upTo(loop.workers)
        for (worker in 0 until first.count) first[worker].clear()
        loop.run(population.size, body = takeFirst)
        for (worker in 1 until first.count) first[0].merge(first[worker])
        setMeans(first[0])
        central.upTo(loop.workers)
        for (worker in 0 until central.count) central[worker].clear(means)
        loop.run(population.size, body = takeCentral)
        for (worker in 1 until central.count) central[0].merge(central[worker])
        this.population = null
        finish(particleMass, central[0])
    }

    private fun setMeans(sums: FirstMoments) {
        val mass = sums.particleMass
        val over = if (mass > 0) 1 / mass else 0.0
        for (axis in 0..2) {
            means.position[axis] = sums.position(axis) * over
            mean[axis] = sums.particleMomentum(axis) * over
        }
        if (flowAxis >= 0) mean[flowAxis] -= rate * means.position[normalAxis]
        mean.copyInto(means.velocity)
        means.setSlabs(sums.count, sums.least, sums.greatest)
        centreZ = means.position[2]
        val x = means.position[0]
        guidingX = if (omega != null) 4 * x + 2 * sums.particleMomentum(1) * over / omega else x
    }

    private fun finish(mass: Double, sums: CentralMoments) {
        val over = if (mass > 0) 1 / mass else 0.0
        for (e in 0 until 6) {
            fit.squares[e] = sums.square(e)
            kinetic[e] = fit.squares[e] * over
        }
        scaleHeight = sqrt(sums.squareOfHeight * over)
        if (flowAxis >= 0) sums.fill(fit)
        fit.solve(first[0].count, mass, means.slabCount)
    }
}

/** One object per worker, made by [make] when it is first needed. */
private class Workers<T>(private val make: () -> T) {
    private val all = ArrayList<T>()

    /** How many there are; there is at least one. */
    val count: Int get() = all.size

    init {
        upTo(1)
    }

    operator fun get(worker: Int): T = all[worker]

    fun upTo(workers: Int) {
        while (all.size < workers) all += make()
    }
}
