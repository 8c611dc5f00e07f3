package daphnis.actors

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population

/** A gas at φ = 0.15 in a long box, periodic or sheared. */
fun gas(count: Int, seed: Long): Pair<Population, BoundaryConditions> {
    val random = SeededRandom(seed)
    val width = Math.cbrt(count * Math.PI / 6 / 0.15 / 4)
    val box = Box.centred(width, 4 * width, width)
    val boundary = if (seed % 3 == 0L) LeesEdwards(box, 0.1) else Periodic(box)
    val places = RandomPlacement(10_000).place(DoubleArray(count) { 0.5 }, box, BooleanArray(3), random)
    fun gauss() = DoubleArray(count) { random.nextGaussian() }
    return Population(
        places.x,
        places.y,
        places.z,
        gauss(),
        gauss(),
        gauss(),
        DoubleArray(count) {
            0.5
        },
        DoubleArray(count) { 1.0 },
    ) to
        boundary
}
