package daphnis.actors

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.population.Population
import daphnis.core.randomSpheres

/** A gas at φ = 0.15 in a long box, periodic or sheared. */
fun gas(count: Int, seed: Long): Pair<Population, BoundaryConditions> {
    val width = Math.cbrt(count * Math.PI / 6 / 0.15 / 4)
    val box = Box.centred(width, 4 * width, width)
    val boundary = if (seed % 3 == 0L) LeesEdwards(box, 0.1) else Periodic(box)
    return randomSpheres(count, boundary, seed, 1.0) { 0.5 } to boundary
}
