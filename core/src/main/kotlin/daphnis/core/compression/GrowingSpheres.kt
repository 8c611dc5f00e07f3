package daphnis.core.compression

import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.Growth
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.boundary.Periodic
import daphnis.core.force.Drift
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.FirstMoments
import daphnis.core.population.Partition
import daphnis.core.population.Partitioned
import daphnis.core.population.Population
import daphnis.core.population.PopulationFold
import daphnis.core.population.SphereSum
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A periodic box in which all spheres grow in proportion while they collide: the radius of sphere i at time t is aᵢ (1
 * + Γ (t − from)) (Lubachevsky & Stillinger 1990, J. Stat. Phys. 60, 561). It is the boundary of a simulation, which
 * acts as its [Drift] too; there is no other. A pair in contact flies apart at the speed at which its surfaces move
 * apart, in addition to what the law of collisions makes of the speed at which they met.
 *
 * **No engine knows of radii that change.** Let γ be the rate at the start of a step of length h, a(t) = a₀ (1 + γ t),
 * and s = 1 + γ h. In the coordinates x′ = x/(1 + γ t) radii are fixed, and in the time t′ = s t/(1 + γ t), which ends
 * at h too, free paths are straight: x′ = x₀ + (v − γ x₀) t′/s. Only the box shrinks: images approach at the rate γ/s
 * ([approach]). So a step is one of fixed spheres with velocities (v − γ x)/s, after which a velocity w means v = w +
 * γ x′, and all lengths are multiplied by s. Free paths and contacts are exact, for any length of the step.
 *
 * Places count from the middle of the box here. Contacts exchange momentum as they do at rest, and Σ m v stays to
 * round-off. Radii change at the end of the step alone, so states, files and checkpoints have those of their time.
 *
 * @property rate Γ, the growth of a radius per unit of time over the radius at the time [from]; < 0 for spheres that
 *   shrink
 * @property from the time at which radii were those from which [rate] counts
 * @property thermostat whether peculiar velocities are multiplied by one factor at the end of each step, so that their
 *   energy is what it was at its start, and the mean velocity is 0; not while [reducedPressure] cannot be known
 * @throws IllegalArgumentException for a box that is not finite, or a rate that is 0 or not finite
 */
public class GrowingSpheres @JvmOverloads constructor(
    override val box: Box,
    public val rate: Double,
    public val from: Double = 0.0,
    public val thermostat: Boolean = true,
) : PerSphereBoundary,
    Growth,
    Drift,
    Partitioned {
    override var partition: Partition = Partition.Whole
    private val periodic = Periodic(box)
    private var loop: RangeLoop = InlineLoop
    private val fold = PopulationFold(null, Int.MAX_VALUE)
    private val sums = FirstMoments(0, Int.MAX_VALUE)

    private val centre = DoubleArray(AXES) { (box.lower(it) + box.upper(it)) / 2 }

    /** γ and s of the step under way; 0 and 1 outside a step. */
    private var gamma = 0.0
    private var scale = 1.0
    private var energyBefore = 0.0

    init {
        require(rate != 0.0 && rate.isFinite()) { "the rate of growth is $rate; it must be finite and not 0" }
        require(from.isFinite()) { "the growth counts from $from; it must be finite" }
    }

    /**
     * The reduced pressure Z = P V/(N kT) in the last step, from the energy that growing spheres gave to the gas: dE =
     * d N kT (Z − 1) da/a in d dimensions. NaN before the first step, with fewer than two spheres, where none moves
     * relative to the others, and where radii grow by less than their rounding. It holds for elastic collisions only.
     */
    override var reducedPressure: Double = Double.NaN
        internal set

    override fun resume(reducedPressure: Double) {
        this.reducedPressure = reducedPressure
    }

    override fun fillingFactor(population: Population): Double {
        val radius = population.radius
        return SphereSum().of(population, partition) { space.volume(radius[it]) } / box.volume
    }

    override val approach: Double get() = gamma / scale

    override val growth: Growth get() = this

    override fun contactFaces(axis: Int): ContactFaces = periodic.contactFaces(axis)

    override fun useLoop(loop: RangeLoop) {
        this.loop = loop
    }

    /** Radii at [time] over those at the time [from]. */
    public fun scaleAt(time: Double): Double = 1 + rate * (time - from)

    /**
     * @throws IllegalArgumentException for a step in which radii change by more than a tenth, or shrink to nothing, or
     *   a sphere touches its own image
     */
    override fun beforeDrift(population: Population, start: Double, duration: Double) {
        gamma = rate / scaleAt(start)
        require(scaleAt(start) > 0 && abs(gamma) * duration <= MOST) {
            gamma = 0.0
            val factor = scaleAt(start + duration) / scaleAt(start)
            "radii change by the factor $factor in the step from time $start to " +
                "${start + duration}; it must be a tenth at most, so take a smaller dt or rate"
        }
        scale = 1 + gamma * duration
        requireRoom(population, start + duration)
        energyBefore = energy(population, gamma)
        loop.runLight(population.size) { _, first, end ->
            for (axis in 0 until AXES) {
                val x = population.position(axis)
                val v = population.velocity(axis)
                val middle = centre[axis]
                for (k in first until end) v[k] = (v[k] - gamma * (x[k] - middle)) / scale
            }
        }
    }

    private fun requireRoom(population: Population, end: Double) {
        val radius = doubleArrayOf(population.radius.maxOrNull() ?: 0.0)
        partition.max(radius)
        val largest = radius[0] * scale
        for (axis in 0 until space.dimensions) {
            if (2 * largest * SLIGHTLY_MORE < box.length(axis)) continue
            gamma = 0.0
            throw IllegalArgumentException(
                "the largest sphere has a radius of $largest at time $end, and touches its own image along " +
                    "${"xyz"[axis]} in a box ${box.length(axis)} long",
            )
        }
    }

    override fun endStep(population: Population, time: Double, from: Int, to: Int) {
        if (gamma != 0.0) {
            for (axis in 0 until AXES) {
                val x = population.position(axis)
                val v = population.velocity(axis)
                val middle = centre[axis]
                for (k in from until to) {
                    val away = x[k] - middle
                    v[k] += gamma * away
                    x[k] = middle + away * scale
                }
            }
        }
        periodic.endStep(population, time, from, to)
    }

    override fun afterDrift(population: Population, end: Double, duration: Double) {
        val by = scale
        val rateBefore = gamma
        gamma = 0.0
        scale = 1.0
        population.sets.separateFixed()
        val radius = population.radius
        loop.runLight(population.size) { _, first, last ->
            for (k in first until last) radius[k] *= by
        }
        val energy = energy(population, rateBefore)
        val n = sums.spheres
        val isKnown = energyBefore > 0 && energy > 0 && by != 1.0
        val work = StrictMath.log(energy / energyBefore) / (2 * StrictMath.log(by))
        reducedPressure = if (isKnown) 1 + (n - 1.0) / n * work else Double.NaN
        if (!thermostat || !(energyBefore > 0 && energy > 0)) return
        val factor = sqrt(energyBefore / energy)
        loop.runLight(population.size) { _, first, last ->
            for (axis in 0 until AXES) {
                val v = population.velocity(axis)
                val mean = means[axis]
                for (k in first until last) v[k] = (v[k] - mean) * factor
            }
        }
    }

    private val means = DoubleArray(AXES)

    /**
     * That of velocities around their mean, which is in [means] afterwards; the same bits for any order of spheres. 0
     * where it is lost in the rounding of the energy of all, or of the velocities of a step with the rate [gamma].
     */
    private fun energy(population: Population, gamma: Double): Double {
        fold.over(population, loop) { fold.first(sums) }
        sums.mergeAll(partition)
        val mass = sums.mass
        val total = sums.kineticEnergy
        var energy = total
        for (axis in 0 until AXES) {
            val momentum = sums.momentum(axis)
            means[axis] = if (mass > 0) momentum / mass else 0.0
            energy -= momentum * means[axis] / 2
        }
        val widest = (0 until space.dimensions).maxOf { abs(gamma) * box.length(it) }
        val rounding = maxOf(LOST * total, LOST_IN_FLOW * mass * widest * widest)
        return if (sums.spheres > 1 && energy > rounding) energy else 0.0
    }

    internal companion object {
        private const val AXES = 3

        /** By how much radii may change in a step. */
        const val MOST = 0.1

        /** Below these parts of the kinetic energy, and of that of speeds γL, peculiar energies are rounding. */
        private const val LOST = 1e-12
        private const val LOST_IN_FLOW = 1e-20

        /** Just above 1. */
        private const val SLIGHTLY_MORE = 1 + 1e-9
    }
}
