package daphnis.core

import daphnis.core.boundary.ContactFaces
import daphnis.core.search.Overlap
import org.junit.jupiter.api.Assertions.assertTrue

/**
 * What must hold after every step: finite, in the box, no overlap deeper than [overlap] of the sum of radii.
 */
fun assertInvariants(simulation: Simulation, overlap: Double = 1e-11) {
    val p = simulation.population
    for (axis in 0..2) {
        if (simulation.boundary.contactFaces(axis) == ContactFaces.OPEN) continue
        val a = listOf(p.x, p.y, p.z)[axis]
        for (k in 0 until p.size) {
            assertTrue(a[k].isFinite()) { "${"xyz"[axis]} of ${p.id[k]} is ${a[k]}" }
            assertTrue(a[k] >= simulation.boundary.box.lower(axis) && a[k] <= simulation.boundary.box.upper(axis)) {
                "${"xyz"[axis]} of ${p.id[k]} is ${a[k]}, outside"
            }
        }
    }
    for (k in 0 until p.size) assertTrue(p.vx[k].isFinite() && p.vy[k].isFinite() && p.vz[k].isFinite())
    val deepest = Overlap.deepest(p, simulation.boundary, simulation.time)
    assertTrue(deepest.depth <= overlap) {
        "spheres ${deepest.first} and ${deepest.second} overlap by ${deepest.depth} after step ${simulation.step}"
    }
}
