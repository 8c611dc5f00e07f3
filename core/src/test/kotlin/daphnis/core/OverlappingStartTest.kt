package daphnis.core

import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** A program's spheres must not overlap at the start, as a scenario's must not. */
class OverlappingStartTest {
    private fun pair(distance: Double) = populationOf(Sphere(vx = 1.0), Sphere(x = distance), Sphere(y = 8.0))

    private fun refusal(simulation: Simulation) =
        assertThrows(IllegalArgumentException::class.java) { simulation.advance() }.message!!

    @Test
    fun `they are refused at the first step, which then has not begun, and may go on once they are apart`() {
        val spheres = pair(1.5)
        val before = stateDigest(spheres)
        val simulation = simulationOf(spheres, Open, 0.1)
        repeat(2) {
            val message = refusal(simulation)
            assertTrue(message.startsWith("spheres 0 and 1 overlap by 0.25 of the sum of their radii")) { message }
        }
        assertEquals(before, stateDigest(spheres))
        spheres.x[1] = 2.0
        simulation.advance()
        // The state of a run that goes on is not judged.
        simulation.population.x[simulation.population.indexOf(1)] = 1.5
        simulation.advance()
    }

    @Test
    fun `what touches within rounding does not overlap`() {
        simulationOf(pair(2.0), Open, 0.1).advance()
        simulationOf(pair(2.0 - 1e-12), Open, 0.1).advance()
        refusal(simulationOf(pair(2.0 - 1e-8), Open, 0.1))
    }

    @Test
    fun `they may overlap through a face, also one that slides`() {
        val box = Box.centred(20.0, 20.0, 20.0)
        refusal(simulationOf(populationOf(Sphere(x = -9.5), Sphere(x = 9.5)), Periodic(box), 0.1))
        fun overlaps(time: Double, x: Double): Boolean {
            val simulation = Simulation.builder(populationOf(Sphere(y = -9.5), Sphere(x = x, y = 9.5)))
                .boundary(LeesEdwards(box, 0.5))
                .restitution(ConstantRestitution(1.0))
                .timeStep(0.1)
                .startTime(time)
                .build()
            return runCatching { simulation.advance() }.isFailure
        }
        assertEquals(listOf(0.0), listOf(-5.0, 0.0, 5.0).filter { overlaps(0.0, it) })
        // At time 0.5 the images are 5 farther along.
        assertEquals(listOf(5.0), listOf(-5.0, 0.0, 5.0).filter { overlaps(0.5, it) })
    }

    @Test
    fun `spheres that pass through one another may overlap, and so may a state that a run left`() {
        fun begin(): SimulationBuilder = Simulation.builder(pair(1.5)).boundary(Open).timeStep(0.1)
        begin().withoutCollisions().build().advance()
        begin().restitution(ConstantRestitution(1.0)).startStep(1).build().advance()
    }

    @Test
    fun `spheres that no engine takes are refused as engines do, not searched for pairs`() {
        fun column(value: Double) = DoubleArray(2) { value * it }
        val still = column(0.0)
        val ones = DoubleArray(2) { 1.0 }
        val far = Population(column(1e300), still, still, still, still, still, ones, ones)
        val message = refusal(simulationOf(far, Periodic(Box.centred(9.0, 9.0, 9.0)), 0.1))
        assertTrue("outside the box" in message) { message }
    }
}
