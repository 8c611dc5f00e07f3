package daphnis.core.source

import daphnis.core.boundary.Box
import daphnis.core.initial.SeededRandom
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Brings [rate] spheres per unit of time on average, as a Poisson process: anywhere in [region], each with the mean
 * [velocity] and components around it that are normal with the standard deviation [sigma]. One that would overlap a
 * sphere or a wall is refused, and does not come later.
 *
 * With [through], spheres come through that face of the box, at any time within the step, and fly on to its end. They are
 * as a gas beyond it sends them: the density of the speed c across the face is as c exp(−(c − u)²/2σ²), where u is that
 * of the stream. In a dilute gas of n spheres per volume at rest the rate is n σ/√(2π) per area.
 *
 * @param region where centres are at first; along the axis of [through] it does not matter
 * @param through 0 to 5 for the faces −x, +x, −y, +y, −z, +z; −1 for none
 * @throws IllegalArgumentException for numbers that are out of range, and where nothing gets through the face
 */
public class Inflow @JvmOverloads constructor(
    public val region: Box,
    public val rate: Double,
    private val velocity: List<Double>,
    private val sigma: Double,
    private val supply: Supply,
    private val through: Int = -1,
) : Source() {
    private val axis = through shr 1
    private val inward = if (through and 1 == 0) 1.0 else -1.0

    init {
        require(rate > 0 && rate.isFinite()) { "the rate is $rate; it must be > 0" }
        require(velocity.size == AXES && velocity.all { it.isFinite() }) { "velocity is $velocity; give three numbers" }
        require(sigma >= 0 && sigma.isFinite()) { "sigma is $sigma; it must be at least 0" }
        require(through in -1..5) { "the face is $through; it must be 0 to 5, or -1" }
        require(region.isFinite) { "the region is infinite" }
        val across = if (through < 0) 0.0 else inward * velocity[axis]
        require(across >= 0 && (through < 0 || across + sigma > 0)) {
            "the stream goes through face $through with $across; it must go inward, or have a sigma > 0"
        }
    }

    override val largest: Double get() = supply.largest

    override fun act(step: SourceStep) {
        require(rate * step.duration <= MOST_AT_ONCE) {
            "a stream brings ${rate * step.duration} spheres in a step; $MOST_AT_ONCE are possible"
        }
        val drawn = ArrayList<Newcomer>()
        var time = -StrictMath.log(1 - step.random.nextDouble()) / rate
        while (time < step.duration) {
            drawn += draw(step, step.duration - time)
            time -= StrictMath.log(1 - step.random.nextDouble()) / rate
        }
        // All nodes have drawn the same, so they all go on or none does.
        if (drawn.isEmpty()) return
        val lower = DoubleArray(AXES) { axis -> drawn.minOf { it.position[axis] } }
        val upper = DoubleArray(AXES) { axis -> drawn.maxOf { it.position[axis] } }
        val near = step.near(lower, upper, largest)
        val come = drawn.filter { sphere ->
            val isFree = step.isInRoom(sphere.position, sphere.radius) && near.isFree(sphere.position, sphere.radius)
            if (isFree) near.add(NO_ID, sphere.position, sphere.radius, isOwn = false)
            isFree
        }
        step.refuse(drawn.size - come.size)
        step.add(come)
    }

    /** A sphere that has been in for the time [since]. */
    private fun draw(step: SourceStep, since: Double): Newcomer {
        val random = step.random
        val radius = supply.radius(random)
        val sphere = Newcomer(radius, supply.mass(radius, step.space), supply.material)
        for (k in 0 until step.space.dimensions) {
            sphere.position[k] = random.nextDouble(region.lower(k), region.upper(k))
            sphere.velocity[k] = velocity[k] + sigma * random.nextGaussian()
        }
        if (through >= 0) {
            sphere.position[axis] = step.face(through, radius)
            sphere.velocity[axis] = inward * speedAcross(random)
            for (k in 0 until step.space.dimensions) sphere.position[k] += sphere.velocity[k] * since
        }
        step.wrap(sphere)
        return sphere
    }

    /**
     * With a density as c exp(−(c − u)²/2σ²). That is at most (u + |c − u|) exp(…), a mixture of a normal and a
     * Rayleigh distribution of c − u, from which it is drawn by rejection.
     */
    private fun speedAcross(random: SeededRandom): Double {
        val u = inward * velocity[axis]
        if (sigma == 0.0) return u
        while (true) {
            val isNormal = random.nextDouble() * (u + sigma * sqrt(2 / PI)) < u
            val d = if (isNormal) {
                random.nextGaussian()
            } else {
                val size = sqrt(-2 * StrictMath.log(1 - random.nextDouble()))
                if (random.nextDouble() < 0.5) size else -size
            }
            if (random.nextDouble() * (u + sigma * abs(d)) < u + sigma * d) return u + sigma * d
        }
    }

    public companion object {
        /** Spheres that may come in a step, on average. */
        public const val MOST_AT_ONCE: Double = 1e7
        private const val AXES = 3
        private const val NO_ID = -1
    }
}
