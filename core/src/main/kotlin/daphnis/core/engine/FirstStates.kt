package daphnis.core.engine

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.collision.PairStates
import daphnis.core.population.Bonds
import daphnis.core.population.Population
import daphnis.core.search.NearPairs

/**
 * Gives the pairs of [population], of whose past nothing is known but which are said to be bound ([Bonds.SAID]), the states
 * that this and their distances at [time] say. Does nothing where pairs have states. Allocates a grid.
 */
internal fun PairStates.bind(population: Population, boundary: BoundaryConditions, time: Double) {
    val said = population.bonds
    if (said !== Bonds.NONE && !Bonds.areSaid(said)) return
    val bonds = Bonds.column(population.size)
    val pairs = NearPairs(population, boundary, time, reach)
    val runs = pairs.runs()
    val radius = population.radius
    for (slot in 0 until population.size) {
        pairs.forEach(runs, slot, radius[pairs.index(slot)] * reach) { k, j, dx, dy, dz ->
            val first = materialOf(population, k)
            val second = materialOf(population, j)
            val contact = radius[k] + radius[j]
            val d2 = dx * dx + dy * dy + dz * dz
            val isBound = said !== Bonds.NONE && Bonds.state(said[k], population.id[j]) != Bonds.UNBOUND
            var state = firstState(first, second, contact, d2)
            if (isBound && state == Bonds.UNBOUND) state = boundState(first, second, contact, d2)
            if (state != Bonds.UNBOUND && !areTied(population.id[k], population.id[j])) {
                bonds[k] = Bonds.with(bonds[k], population.id[j], state)
                bonds[j] = Bonds.with(bonds[j], population.id[k], state)
            }
        }
    }
    population.bind(bonds)
}

private fun materialOf(population: Population, k: Int) =
    if (population.hasMaterials) population.material[k].toInt() else Int.MAX_VALUE
