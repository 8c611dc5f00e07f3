package daphnis.core.force

import daphnis.core.collision.PairStates
import daphnis.core.population.Bonds
import daphnis.core.population.Population

/**
 * The potential energy of pairs among the forces of a simulation. It changes no velocities: engines do that at the
 * edges.
 */
internal class PairEnergy(private val states: PairStates) : PerSphereEnergy {
    override fun beforeDrift(population: Population, start: Double, duration: Double): Unit = Unit

    override fun afterDrift(population: Population, end: Double, duration: Double): Unit = Unit

    override fun potentialEnergies(population: Population, time: Double, from: Int, to: Int, into: DoubleArray) {
        val areBound = population.bonds !== Bonds.NONE
        for (k in from until to) into[k - from] = if (areBound) states.share(population, k) else 0.0
    }
}
