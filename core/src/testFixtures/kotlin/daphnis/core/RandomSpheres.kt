package daphnis.core

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.initial.PlacementException
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population

/**
 * Spheres without overlap in the boundary's box (or a cube of 10 when it has none), velocities normal with deviation
 * [sigma].
 */
fun randomSpheres(
    count: Int,
    boundary: BoundaryConditions,
    seed: Long,
    sigma: Double,
    radius: (SeededRandom) -> Double,
): Population {
    val random = SeededRandom(seed)
    val radii = DoubleArray(count) { radius(random) }
    val box = if (boundary.box.volume.isFinite()) boundary.box else Box.centred(10.0, 10.0, 10.0)
    val walled = BooleanArray(3) { boundary.contactFaces(it) != ContactFaces.PERIODIC }
    val p = try {
        RandomPlacement(20_000).place(radii, box, walled, random)
    } catch (e: PlacementException) {
        // Too dense a draw: half as many do as well.
        return randomSpheres(count / 2, boundary, seed, sigma, radius)
    }
    fun gauss() = DoubleArray(count) { sigma * random.nextGaussian() }
    val masses = DoubleArray(count) { radii[it] * radii[it] * radii[it] }
    return Population(p.x, p.y, p.z, gauss(), gauss(), gauss(), radii, masses)
}
