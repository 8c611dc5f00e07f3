package daphnis.core.physics

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.ShearedPeriodic
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.population.Conserved
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.ln

/**
 * Section 3 of the validation targets: d ln T/dC of the freely cooling gas (van Noije & Ernst 1998, Granular Matter 1,
 * 57).
 */
@Tag("physics")
class CoolingGasTest {
    @Test
    fun `the cooling gas loses energy at the rate of the theory`() {
        for ((e, count, target) in listOf(Triple(0.9, 2000, -0.0631), Triple(0.8, 1000, -0.1196))) {
            var sum = 0.0
            val seeds = if (fullPhysics) 1L..12L else 1L..4L
            for (seed in seeds) {
                val box = cube(count, 0.1)
                val simulation =
                    gasSimulation(gas(count, box, seed, false), Periodic(box), 0.2, e, FloorSpeedGuard(1e-9))
                fun each() = 2.0 * simulation.collisions!!.counters.collisions / count
                // The first collisions bring the velocities to the scaling state; then 30 a sphere.
                while (each() < 8) simulation.advance()
                val c0 = each()
                val t0 = temperature(simulation.population)
                while (each() < c0 + 30) simulation.advance()
                sum += ln(temperature(simulation.population) / t0) / (each() - c0)
            }
            assertPhysics("d ln T/dC, e = $e", target, sum / seeds.count(), 0.025)
        }
    }

    @Test
    fun `without shear energy never rises, though wraps of the paper's box land spheres on one another`() {
        val box = Box.centred(12.0, 12.0, 3.0)
        val p = gas(120, box, 5, false)
        val simulation = gasSimulation(p, ShearedPeriodic(box, 0.0), 0.1, 0.8, FloorSpeedGuard(1e-9))
        var energy = Conserved.of(p).kineticEnergy
        repeat(500) {
            simulation.advance()
            val now = Conserved.of(p).kineticEnergy
            assertTrue(now <= energy * (1 + 1e-14)) { "energy rises from $energy to $now in step ${simulation.step}" }
            energy = now
        }
        assertTrue(simulation.collisions!!.counters.collisions > 500)
    }
}
