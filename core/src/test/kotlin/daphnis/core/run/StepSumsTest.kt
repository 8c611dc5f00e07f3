package daphnis.core.run

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.force.BodyGravity
import daphnis.core.force.PerSphereEnergy
import daphnis.core.force.UniformAcceleration
import daphnis.core.population.Partition
import daphnis.core.population.Partitioned
import daphnis.core.population.PopulationSums
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class StepSumsTest {
    private val pull = UniformAcceleration(0.0, 0.0, -2.0)
    private val bodies = BodyGravity(intArrayOf(0), Open, 0.5)

    private fun simulation() = Simulation(
        populationOf(Sphere(z = 3.0, m = 2.0), Sphere(x = 4.0, z = 3.0, m = 1.0)),
        Open,
        null,
        FixedTimeStep(0.1),
        listOf(pull, bodies),
    )

    @Test
    fun `sums and energies are of the step, and of the state when they are taken again`() {
        val s = simulation()
        val sums = StepSums(PopulationSums(null))
        assertEquals(2.0 * 3 * 3, sums.potentialEnergy(s, pull))
        assertEquals(-0.5 * 2 / 4, sums.potentialEnergy(s, bodies))
        assertEquals(3.0, sums.of(s).centreZ)
        s.population.z[0] = 6.0
        assertEquals(2.0 * 3 * 3, sums.potentialEnergy(s, pull)) { "of one state all" }
        sums.take(s)
        assertEquals(2.0 * (2 * 6 + 3), sums.potentialEnergy(s, pull))
        assertEquals(5.0, sums.of(s).centreZ)
        s.advance()
        assertTrue(sums.potentialEnergy(s, pull) < 30)
        assertEquals(pull.potentialEnergy(s.population, s.boundary, s.time), sums.potentialEnergy(s, pull))
        assertEquals(5.0 - 0.01, sums.of(s).centreZ, 1e-3)
    }

    /** A force that knows of nodes, and has an energy that each sphere has by itself. */
    private class Both(pull: UniformAcceleration) :
        PerSphereEnergy by pull,
        Partitioned {
        override var partition: Partition = Partition.Whole
    }

    @Test
    fun `an energy that each sphere has by itself is summed as such, also of a force that asks nodes`() {
        val both = Both(pull)
        val p = populationOf(Sphere(z = 3.0, m = 2.0))
        val s = Simulation(p, Open, null, FixedTimeStep(0.1), listOf(both))
        val sums = StepSums(PopulationSums(null))
        assertEquals(2.0 * 2 * 3, sums.potentialEnergy(s, both))
        s.population.z[0] = 6.0
        assertEquals(2.0 * 2 * 3, sums.potentialEnergy(s, both)) { "of one state all" }
    }

    @Test
    fun `conserved sums are those of the population, and a force through periodic faces has no energy`() {
        val s = simulation()
        s.advance()
        assertEquals(-2.0 * 0.1 * 3, s.conserved().momentumZ, 1e-12)
        assertEquals(2, s.conserved().count)
        val periodic =
            Simulation(s.population, Periodic(Box.centred(40.0, 40.0, 40.0)), null, FixedTimeStep(0.1), listOf(pull))
        assertTrue(StepSums(PopulationSums(null)).potentialEnergy(periodic, pull).isNaN())
    }
}
