package daphnis.core.hill

import daphnis.core.force.Kick
import daphnis.core.force.PerSphereEnergy
import daphnis.core.force.Pulls
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Carried
import daphnis.core.population.ExactSum
import daphnis.core.population.Partition
import daphnis.core.population.Partitioned
import daphnis.core.population.Population
import kotlin.math.sqrt

/**
 * The pull of a moon, in Hill's frame: −GM (r − r_s)/(|r − r_s|² + ε²)^{3/2}. The moon need not be near the patch: a
 * moon beside a ring drifts past it with the shear. The acceleration of the planet by the moon is neglected, as in
 * Hill's limit. There is one moon, without images, so a patch that is periodic along the orbit is followed past it once,
 * or, with a [circumference], once in a synodic period, circumference/(s X).
 *
 * A moon of infinite [mass] keeps its orbit. One of a finite mass takes up the exact sum of what it gives to all spheres,
 * whatever their order and wherever they are: a kick conserves Σ m v of spheres and moon to round-off, and so their
 * angular momentum, Σ m X with the guiding centres X, is constant where nothing comes back through a face. Moons do not
 * attract one another. A moon of a finite mass is of one simulation, whose steps move it.
 *
 * @param gravitationalParameter G times the mass, in length³/time²
 * @param orbit the moon's epicycle at [epoch]
 * @param frequencies of orbits in the frame
 * @param softening ε, length
 * @property circumference of the orbit, length: the moon comes back on the other side when its guiding centre is half
 *   of it away, with the phases that κ and ν have given it by then. Infinite for a moon that passes once
 * @property mass of the moon as it feels forces, > 0; infinite for one that feels none
 * @param epoch a time
 */
public class Satellite @JvmOverloads constructor(
    public val gravitationalParameter: Double,
    orbit: Epicycle,
    private val frequencies: OrbitalFrequencies,
    public val softening: Double = 0.0,
    public val circumference: Double = Double.POSITIVE_INFINITY,
    public val mass: Double = Double.POSITIVE_INFINITY,
    epoch: Double = 0.0,
) : Kick,
    PerSphereEnergy,
    Partitioned,
    Carried {
    override var partition: Partition = Partition.Whole
    private var loop: RangeLoop = InlineLoop
    private val pulls = Pulls()
    private val sums = Array(3) { ExactSum() }

    /** Whether the moon moves as the spheres pull it. */
    public val isFree: Boolean get() = mass.isFinite()

    /** Its epicycle at [epoch], which is the end of the last step if it [isFree]. */
    public var orbit: Epicycle = orbit
        private set

    /** When it was on [orbit]. */
    public var epoch: Double = epoch
        private set

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
        require(orbit.elements().all { it.isFinite() }) { "the orbit of the satellite is not finite" }
        require(mass > 0) { "mass of the satellite is $mass; it must be > 0" }
        require(epoch.isFinite()) { "epoch of the satellite is $epoch; it must be finite" }
        require(!isFree || frequencies.nu > 0) {
            "a satellite which feels forces needs a force towards the midplane: its vertical factor is 0"
        }
    }

    override fun useLoop(loop: RangeLoop) {
        this.loop = loop
    }

    /** Position and velocity x y z v_x v_y v_z at [time]. Allocates. */
    public fun state(time: Double): DoubleArray = orbit(time).state(frequencies)

    /** Its epicycle at [time], on a circle where it has a [circumference]. */
    public fun orbit(time: Double): Epicycle {
        val now = orbit.after(time - epoch, frequencies)
        return if (circumference.isFinite()) now.onCircle(circumference) else now
    }

    /** Hill's energy of its own motion at the end of the last step, mass · (length/time)²; 0 unless it [isFree]. */
    public val energy: Double get() = if (isFree) mass * orbit.energy(frequencies) else 0.0

    override fun kick(population: Population, time: Double, duration: Double) {
        val now = orbit(time)
        val at = now.state(frequencies)
        if (!isFree) {
            loop.run(population.size) { _, from, to -> kick(population, at, duration, from, to) }
            return
        }
        pulls.prepare(population.size)
        loop.run(population.size) { _, from, to ->
            pulls.clear(from, to)
            kick(population, at, duration, from, to)
        }
        pulls.sum(population.size, sums)
        partition.merge(sums)
        val (px, py, pz) = sums.map { it.value() }
        orbit = now.kicked(-px / mass, -py / mass, -pz / mass, frequencies)
        epoch = time
    }

    private fun kick(population: Population, at: DoubleArray, duration: Double, from: Int, to: Int) {
        val softening2 = softening * softening
        val strength = gravitationalParameter * duration
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
            if (isFree) pulls.put(k, population.mass[k] * f, dx, dy, dz)
        }
    }

    /** The elements of [orbit] and [epoch]; none of a moon that keeps its orbit. */
    override var carried: DoubleArray
        get() = if (isFree) orbit.elements() + epoch else DoubleArray(0)
        set(value) {
            if (!isFree) return
            require(value.size == Epicycle.ELEMENTS + 1) { "${value.size} numbers are no state of a satellite" }
            orbit = Epicycle.ofElements(value)
            epoch = value[Epicycle.ELEMENTS]
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
