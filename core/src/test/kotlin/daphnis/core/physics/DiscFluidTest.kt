package daphnis.core.physics

import daphnis.core.Simulation
import daphnis.core.engine.CollisionForcing
import daphnis.core.run.CollisionStatistics
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSetup
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.sqrt

/**
 * The pressure of hard discs just below the density at which they order, beside that of HOOMD's own test
 * (hoomd/hpmc/pytest/test_disk_equation_of_state.py, commit 49a74aae): βPσ² = 9.1709(2) at an area fraction of 0.698,
 * 256² discs.
 */
@Tag("physics")
class DiscFluidTest {
    @Test
    fun `discs near their transition have the pressure of HOOMD`() {
        val count = if (fullPhysics) 128 * 128 else 32 * 32
        val edge = sqrt(count * PI / 4 / FILLING)
        val settle = if (fullPhysics) 100.0 else 20.0
        val scenario = BuiltIn.scenario(
            "hard-discs",
            listOf(
                "particles.count=$count",
                "box.lengths=[$edge,$edge]",
                "placement={\"type\":\"grown\"}",
                "velocities={\"type\":\"gaussian\",\"temperature\":1,\"exact\":true}",
                "timeStep={\"type\":\"fixed\",\"dt\":0.05}",
            ),
        )
        val setup = ScenarioSetup.of(scenario, "discs")
        val statistics = CollisionStatistics(from = settle)
        val law = CollisionForcing(setup.restitution, setup.guard, recordCollisions = true)
        val steps = setup.timeStep
        Simulation(setup.population, setup.boundary, law, steps, outputs = listOf(statistics)).use {
            val end = settle + if (fullPhysics) 200.0 else 60.0
            while (it.time < end) it.advance()
            val p = it.population
            // Of N − 1 free discs.
            val t = (0 until count).sumOf { k -> p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k] } / 2 / (count - 1)
            val virial = (statistics.virial[0] + statistics.virial[4]) / 2 / (it.time - settle)
            val pressure = (count + virial / t) / (edge * edge)
            assertPhysics("βPσ², discs, ν = $FILLING", 9.1709, pressure, if (fullPhysics) 0.003 else 0.01)
        }
    }

    private companion object {
        const val FILLING = 0.698
    }
}
