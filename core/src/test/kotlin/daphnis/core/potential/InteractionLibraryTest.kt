package daphnis.core.potential

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.randomSpheres
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The example of interactions in docs/library.md. */
class InteractionLibraryTest {
    @Test
    fun `a gas in square wells`() {
        val boundary = Periodic(Box.centred(9.0, 9.0, 9.0))
        val gas = randomSpheres(100, boundary, 4, 1.0) { 0.5 }
        // example: interactions
        val drops = PairInteractions(SteppedPotential.squareWell(1.5, 1.0))
        val collisions = CollisionForcing.builder(ConstantRestitution(1.0)).interactions(drops).build()
        val simulation = Simulation(gas, boundary, collisions, FixedTimeStep(0.05))
        fun energy() = simulation.conserved().kineticEnergy +
            simulation.forces.sumOf { it.potentialEnergy(simulation.population, boundary, simulation.time) }
        val before = energy()
        while (simulation.time < 5.0) simulation.advance()
        println("${collisions.counters.edgeEvents} events at edges; energy $before -> ${energy()}")
        // end
        assertEquals(before, energy(), 1e-10)
        assertTrue(collisions.counters.edgeEvents > 500)
    }
}
