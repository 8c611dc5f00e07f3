package daphnis.core

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class TimeStepTest {
    @Test
    fun `the fastest component decides how long a step is, and the longest is the limit`() {
        val p = populationOf(Sphere(vx = 0.5, vy = -4.0), Sphere(x = 5.0, vz = 3.0))
        assertEquals(0.25 * 2.0 / 4.0, CellCrossingTimeStep(0.25, 2.0, 10.0).next(p))
        assertEquals(0.1, CellCrossingTimeStep(0.25, 2.0, 0.1).next(p))
        assertEquals(7.0, CellCrossingTimeStep(0.25, 2.0, 7.0).next(populationOf(Sphere())))
    }

    @Test
    fun `steps that are none are refused`() {
        assertThrows(IllegalArgumentException::class.java) { FixedTimeStep(0.0) }
        assertThrows(IllegalArgumentException::class.java) { FixedTimeStep(Double.NaN) }
        assertThrows(IllegalArgumentException::class.java) { CellCrossingTimeStep(-1.0, 1.0, 1.0) }
        assertThrows(IllegalArgumentException::class.java) { CellCrossingTimeStep(1.0, 0.0, 1.0) }
    }

    @Test
    fun `times of fixed steps are multiples of the step, whatever their number`() {
        val simulation =
            Simulation(populationOf(Sphere()), Periodic(Box.centred(9.0, 9.0, 9.0)), null, FixedTimeStep(0.1))
        repeat(1000) { simulation.advance() }
        assertEquals(1000 * 0.1, simulation.time)
    }

    @Test
    fun `a simulation that starts at another time goes on from there`() {
        val simulation =
            Simulation(
                populationOf(Sphere()),
                Periodic(Box.centred(9.0, 9.0, 9.0)),
                null,
                FixedTimeStep(0.5),
                startTime = 7.25,
            )
        simulation.advance()
        assertEquals(7.75, simulation.time)
    }

    @Test
    fun `without collisions spheres pass through one another`() {
        val p = populationOf(Sphere(x = -3.0, vx = 1.0), Sphere(x = 3.0, vx = -1.0))
        val simulation = Simulation(p, Periodic(Box.centred(20.0, 20.0, 20.0)), null, FixedTimeStep(1.0))
        repeat(6) { simulation.advance() }
        assertEquals(listOf(3.0, -3.0), p.x.toList())
    }
}
