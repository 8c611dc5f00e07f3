package daphnis.core.hill

import daphnis.core.force.Kick
import daphnis.core.force.PerSphereEnergy
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import kotlin.math.sqrt

/**
 * The pull of a moon on a given orbit, in Hill's frame: −GM (r − r_s)/(|r − r_s|² + ε²)^{3/2}. The moon itself feels no
 * force and need not be near the patch: a moon beside a ring drifts past it with the shear. The acceleration of the
 * planet by the moon is neglected, as in Hill's limit. There is one moon, without images, so a patch that is periodic
 * along the orbit is followed past it once, or, with a [circumference], once in a synodic period, circumference/(s X).
 *
 * @param gravitationalParameter G times the mass, in length³/time²
 * @param orbit the moon's epicycle at time 0
 * @param frequencies of orbits in the frame
 * @param softening ε, length
 * @property circumference of the orbit, length: the moon comes back on the other side when its guiding centre is half
 *   of it away, with the phases that κ and ν have given it by then. Infinite for a moon that passes once
 */
public class Satellite @JvmOverloads constructor(
    public val gravitationalParameter: Double,
    private val orbit: Epicycle,
    private val frequencies: OrbitalFrequencies,
    public val softening: Double = 0.0,
    public val circumference: Double = Double.POSITIVE_INFINITY,
) : Kick,
    PerSphereEnergy {
    private var loop: RangeLoop = InlineLoop

    /** Around a point mass, in a frame of angular speed [omega]. */
    @JvmOverloads
    public constructor(gravitationalParameter: Double, orbit: Epicycle, omega: Double, softening: Double = 0.0) :
        this(gravitationalParameter, orbit, OrbitalFrequencies(omega), softening)

    init {
        require(gravitationalParameter >= 0 && gravitationalParameter.isFinite()) {
            "GM of the satellite is $gravitationalParameter; it must be at least 0"
        }
        require(softening >= 0 && softening.isFinite()) { "softening is $softening; it must be at least 0" }
        require(circumference > 0) { "circumference is $circumference; it must be > 0" }
    }

    override fun useLoop(loop: RangeLoop) {
        this.loop = loop
    }

    /** Position and velocity x y z v_x v_y v_z at [time]. Allocates. */
    public fun state(time: Double): DoubleArray {
        val now = orbit.after(time, frequencies)
        return (if (circumference.isFinite()) now.onCircle(circumference) else now).state(frequencies)
    }

    override fun kick(population: Population, time: Double, duration: Double) {
        val at = state(time)
        val softening2 = softening * softening
        val strength = gravitationalParameter * duration
        loop.run(population.size) { _, from, to ->
            for (k in from until to) {
                val dx = at[0] - population.x[k]
                val dy = at[1] - population.y[k]
                val dz = at[2] - population.z[k]
                val d2 = dx * dx + dy * dy + dz * dz + softening2
                // A particle in the very centre feels no pull.
                if (d2 == 0.0) continue
                val f = strength / (d2 * sqrt(d2))
                population.vx[k] += f * dx
                population.vy[k] += f * dy
                population.vz[k] += f * dz
            }
        }
    }

    /** −GM m/√(d² + ε²), d being the distance from the moon at [time], without images; 0 in a point moon's centre. */
    override fun potentialEnergies(population: Population, time: Double, from: Int, to: Int, into: DoubleArray) {
        val at = state(time)
        val p = population
        for (k in from until to) {
            val dx = at[0] - p.x[k]
            val dy = at[1] - p.y[k]
            val dz = at[2] - p.z[k]
            val d2 = dx * dx + dy * dy + dz * dz + softening * softening
            into[k - from] = if (d2 == 0.0) 0.0 else -gravitationalParameter * p.mass[k] / sqrt(d2)
        }
    }
}
