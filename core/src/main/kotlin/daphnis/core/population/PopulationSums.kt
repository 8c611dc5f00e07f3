package daphnis.core.population

import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.space.Space
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
 * @param frequencies of orbits in Hill's frame, or null
 * @param firstBody spheres with this id or a higher one are bodies, such as moonlets: they contribute to mass, momentum
 *   and energy, and to nothing else; [Int.MAX_VALUE] for none
 * @param space in which spheres move, see [granularTemperature]
 * @property carriesHeat whether [heat] is summed too
 */
public class PopulationSums @JvmOverloads constructor(
    private var flow: MeanFlow?,
    internal val frequencies: OrbitalFrequencies? = null,
    internal val firstBody: Int = Int.MAX_VALUE,
    internal val space: Space = Space.VOLUME,
    public val carriesHeat: Boolean = false,
) {
    private val flowAxis = flow?.flowAxis ?: -1
    private val normalAxis = flow?.normalAxis ?: 0
    private val fit = FlowFit(flowAxis)
    internal val means: Means = Means()
    private val first = FirstMoments(normalAxis, firstBody)
    private val central = CentralMoments(flow, firstBody, carriesHeat)
    private val whole = PopulationFold(flow, firstBody, carriesHeat)

    /** Number of spheres, including bodies. */
    public val count: Int get() = first.spheres

    /** Σ m of particles and bodies. */
    public val mass: Double get() = first.mass

    /** Σ m v²/2 of particles and bodies. */
    public val kineticEnergy: Double get() = first.kineticEnergy

    /** Σ m v along [axis] of particles and bodies. */
    public fun momentum(axis: Int): Double = first.momentum(axis)

    /** Σ m of the particles. */
    public val particleMass: Double get() = first.particleMass

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

    /**
     * Σ ½ m w² w_a along x, y, z, mass · (length/time)³: the part of the heat flux times volume that particles carry. 0
     * unless it was asked for ([carriesHeat]). Valid until the next [take].
     */
    public val heat: DoubleArray = DoubleArray(3)

    /** ⟨velocity − the boundary's flow⟩ along x, y, z; valid until the next [take]. */
    public val mean: DoubleArray = DoubleArray(3)

    /** Granular temperature ⟨c²⟩/3, in the plane ⟨c²⟩/2, (length/time)². 0 for fewer than two particles. */
    public val granularTemperature: Double
        get() = (fit.moments[0] + fit.moments[1] + fit.moments[2]) / space.dimensions

    /** √(2 E/(d M)) with d dimensions and E, M of particles and bodies: the rms of a component of velocity. */
    public val rmsComponentSpeed: Double
        get() = if (mass > 0) sqrt(2 * kineticEnergy / mass / space.dimensions) else 0.0

    /** Mean height of the particles. */
    public var centreZ: Double = 0.0
        private set

    /** √⟨(z − centre)²⟩. */
    public var scaleHeight: Double = 0.0
        private set

    /** Σ m X / Σ m with X the guiding centre in Hill's frame; otherwise the mean of x. */
    public var guidingX: Double = 0.0
        private set

    /** From now on the boundary drives [flow], along the same axes as before. */
    internal fun drive(flow: MeanFlow?) {
        require(flow?.flowAxis == this.flow?.flowAxis && flow?.normalAxis == this.flow?.normalAxis) {
            "the flow is along another axis than before"
        }
        this.flow = flow
    }

    /** Takes the sums of the present state of [population] on the threads of [loop]. All are 0 for an empty one. */
    @JvmOverloads
    public fun take(population: Population, loop: RangeLoop = InlineLoop) {
        whole.over(population, loop) { take(whole) }
    }

    /**
     * Takes the sums of a population that is held in [parts]: those of first moments, then the means, then those of
     * second moments around them. The result has the same bits for any division. When this throws, the sums are not to
     * be used before the next call.
     */
    internal fun take(parts: SumParts) {
        parts.first(first)
        setMeans(first)
        parts.central(means, central)
        finish(particleMass, central)
    }

    private fun setMeans(sums: FirstMoments) {
        val mass = sums.particleMass
        val over = if (mass > 0) 1 / mass else 0.0
        for (axis in 0..2) {
            means.position[axis] = sums.position(axis) * over
            mean[axis] = sums.particleMomentum(axis) * over
        }
        for (axis in 0..2) {
            val gradient = flow?.gradient(axis) ?: 0.0
            means.gradient[axis] = gradient
            if (gradient != 0.0) mean[axis] -= gradient * means.position[normalAxis]
        }
        mean.copyInto(means.velocity)
        means.setSlabs(sums.count, sums.least, sums.greatest)
        centreZ = means.position[2]
        val x = means.position[0]
        guidingX = frequencies?.guidingX(x, sums.particleMomentum(1) * over) ?: x
    }

    private fun finish(mass: Double, sums: CentralMoments) {
        val over = if (mass > 0) 1 / mass else 0.0
        for (e in 0 until 6) {
            fit.squares[e] = sums.square(e)
            kinetic[e] = fit.squares[e] * over
        }
        if (carriesHeat) for (axis in 0..2) heat[axis] = sums.heat(axis)
        scaleHeight = sqrt(sums.squareOfHeight * over)
        if (flowAxis >= 0) sums.fill(fit)
        fit.solve(first.count, mass, means.slabCount)
    }
}
