package daphnis.core.population

import daphnis.core.surface.SurfaceContact

/**
 * Sums over the spins of a population, exact ([ExactSum]), so that they are the same to the last bit for every order of
 * the arrays. Made once and filled by [take]. All are 0 for spheres without spins.
 *
 * @param momentFactor moment of inertia of spheres over mass · radius²
 */
public class SpinSums @JvmOverloads constructor(private val momentFactor: Double = SurfaceContact.SOLID) {
    private val energy = ExactSum()
    private val masses = ExactSum()
    private val spins = Array(AXES) { ExactSum() }
    private val momenta = Array(AXES) { ExactSum() }
    private val size = ExactSum()

    /** Σ I ω²/2. */
    public val energyOfRotation: Double get() = energy.value() / 2

    /**
     * ⟨I ω²⟩/3 over the mean mass, (length/time)²: comparable with the granular temperature ⟨c²⟩/3. The mean spin is not
     * taken off. 0 without spheres.
     */
    public val temperature: Double get() = masses.value().let { if (it > 0) energy.value() / it / AXES else 0.0 }

    /** Mean of ω along [axis] over all spheres. */
    public fun mean(axis: Int): Double = size.value().let { if (it > 0) spins[axis].value() / it else 0.0 }

    /**
     * Σ (m **r** × **v** + I **ω**) along [axis], about the origin. It means something only where space neither repeats
     * nor turns.
     */
    public fun angularMomentum(axis: Int): Double = momenta[axis].value()

    /** Takes the sums of the present state of [population]. */
    public fun take(population: Population) {
        for (sum in spins.asList() + momenta + energy + masses + size) sum.clear()
        if (!population.hasSpin) return
        val p = population
        for (k in 0 until p.size) {
            val m = p.mass[k]
            val inertia = momentFactor * m * p.radius[k] * p.radius[k]
            energy.add(inertia * (p.wx[k] * p.wx[k] + p.wy[k] * p.wy[k] + p.wz[k] * p.wz[k]))
            masses.add(m)
            size.add(1.0)
            for (axis in 0 until AXES) {
                val a = (axis + 1) % AXES
                val b = (axis + 2) % AXES
                val spin = p.column(SPIN + axis)[k]
                spins[axis].add(spin)
                momenta[axis].add(inertia * spin)
                momenta[axis].add(m * (p.position(a)[k] * p.velocity(b)[k]))
                momenta[axis].add(-m * (p.position(b)[k] * p.velocity(a)[k]))
            }
        }
    }

    private companion object {
        const val AXES = 3
        val SPIN = SphereQuantity.SPIN.place
    }
}
