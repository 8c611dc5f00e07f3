package daphnis.core.surface

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.MaterialSums
import daphnis.core.population.PopulationSums
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The examples of rough spheres and materials in docs/library.md. */
class RoughLibraryTest {
    @Test
    fun `a law of one's own is asked about each impact`() {
        val smooth = populationOf(Sphere(x = -2.0, vx = 1.0, vy = 0.5), Sphere(x = 2.0, y = 1.0, vx = -1.0, r = 1.5))
        // example: rough
        val none = DoubleArray(smooth.size)
        val population = smooth.withSpin(none, none, none) // radians per unit of time
        // Small spheres are rougher: from 1/2 for two of radius 1 down to −1, which is smooth.
        val roughness = Roughness { contact -> 1.5 / maxOf(1.0, contact.firstRadius * contact.secondRadius) - 1 }
        val collisions = CollisionForcing(ConstantRestitution(0.8), roughness = roughness)
        val simulation = Simulation(population, Open, collisions, FixedTimeStep(0.1))
        while (simulation.time < 2.0) simulation.advance()
        println("spins about z: ${simulation.population.wz.toList()}")
        // end
        assertEquals(1L, collisions.counters.collisions)
        val (one, other) = listOf(0, 1).map { simulation.population.wz[simulation.population.indexOf(it)] }
        // Equal impulses: spins are as the inverses of mass · radius.
        assertEquals(1.5, one / other, 1e-12)
        assertTrue(one != 0.0)
    }

    @Test
    fun `materials of one's own have laws by pair`() {
        val boundary = Periodic(Box.centred(9.0, 9.0, 9.0))
        val spheres = randomSpheres(100, boundary, 4, 1.0) { 0.5 }
        // example: materials
        val mixture = spheres.withMaterial(IntArray(spheres.size) { it % 2 }, listOf("ice", "rock"))
        val law = MaterialLaws(ConstantRestitution(0.9)).between(0, 1, ConstantRestitution(0.3))
        val simulation = Simulation(mixture, boundary, CollisionForcing(law), FixedTimeStep(0.1))
        while (simulation.time < 5.0) simulation.advance()
        val sums = PopulationSums(boundary.meanFlow).apply { take(simulation.population) }
        val temperatures = MaterialSums(mixture.materials).apply { take(simulation.population, sums) }
        for ((k, name) in mixture.materials.withIndex()) println("$name: ${temperatures.temperature(k)}")
        // end
        assertTrue(List(2) { temperatures.temperature(it) }.all { it > 0 && it < 0.5 })
    }
}
