package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.population.ExactSum
import daphnis.core.population.Population
import daphnis.core.population.SphereSum

/**
 * A force whose potential energy is a sum over spheres, with a term that each sphere has by itself. So threads and
 * machines take the sum over the spheres that they hold, and the sums are put together.
 */
public interface PerSphereEnergy : Force {
    /** Whether there is a potential energy within [boundary]; otherwise [potentialEnergy] is NaN. */
    public fun hasPotentialEnergy(boundary: BoundaryConditions): Boolean = true

    /**
     * Writes the potential energies at [time] of the spheres of [population] at the indices [from] until [to] to the
     * first entries of [into], mass · (length/time)². Each must depend only on its sphere and [time]. Several threads
     * may call at once, with an array each.
     */
    public fun potentialEnergies(population: Population, time: Double, from: Int, to: Int, into: DoubleArray)

    /** The sum of [potentialEnergies], exact ([ExactSum]); NaN without [hasPotentialEnergy]. Allocates. */
    override fun potentialEnergy(population: Population, boundary: BoundaryConditions, time: Double): Double {
        if (!hasPotentialEnergy(boundary)) return Double.NaN
        val sum = ExactSum()
        SphereSum().addBlocks(0, population.size, sum) { from, to, into ->
            potentialEnergies(population, time, from, to, into)
        }
        return sum.value()
    }
}
