package daphnis.core

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.force.Force
import daphnis.core.population.Carried
import daphnis.core.wall.pistons

/**
 * What a simulation carries from step to step besides the spheres: the reduced pressure of growth, pistons among the
 * walls, and what [forces] carry.
 */
internal class CarriedState(private val boundary: BoundaryConditions, forces: List<Force>) {
    private val carriers: List<Carried> = boundary.walls.pistons.values + forces.filterIsInstance<Carried>()

    /** As numbers, always as many; NaN for the pressure where nothing grows. */
    var numbers: DoubleArray
        get() = doubleArrayOf(boundary.growth?.reducedPressure ?: Double.NaN) +
            carriers.flatMap { it.carried.asList() }
        set(value) {
            boundary.growth?.resume(value[0])
            var from = 1
            for (carrier in carriers) {
                val to = from + carrier.carried.size
                carrier.carried = value.copyOfRange(from, to)
                from = to
            }
        }

    private var before: List<DoubleArray> = emptyList()

    /** A step begins, which may be taken back. */
    fun begin() {
        if (carriers.isNotEmpty()) before = carriers.map { it.carried }
    }

    /** The step that has begun is none. */
    fun takeBack() {
        for ((k, state) in before.withIndex()) carriers[k].carried = state
    }
}
