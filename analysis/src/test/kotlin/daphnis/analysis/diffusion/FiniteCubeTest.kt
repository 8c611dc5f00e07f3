package daphnis.analysis.diffusion

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.engine.CollisionForcing
import daphnis.core.format.Snapshot
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSetup
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.cbrt

class FiniteCubeTest {
    @Test
    fun `viscosity and correction are those worked out by hand`() {
        // φ = 0.3: χ = 0.85/0.343, bχ = 2.9738, 0.17915 · 1.2 · (0.33627 + 0.8 + 2.26424).
        assertEquals(0.73103, FiniteCube.enskogViscosity(1.0, 1.0, 0.3, 1.0), 1e-4)
        // η ~ √(m kT)/σ²; at vanishing density it is η₀.
        assertEquals(0.73103 * 6 / 4, FiniteCube.enskogViscosity(2.0, 4.0, 0.3, 9.0), 2e-4)
        assertEquals(1.016 * 5 / 16 / Math.sqrt(PI), FiniteCube.enskogViscosity(1.0, 1.0, 1e-9, 1.0), 1e-6)
        assertEquals(2.837297 * 3 / (6 * PI * 0.5 * 10), FiniteCube.correction(3.0, 0.5, 10.0), 1e-12)
    }

    /** D at φ = 0.3 and T = 1 of [count] spheres, and that plus the correction. */
    private fun measured(count: Int, seed: Int): Pair<Diffusion, Double> {
        val edge = cbrt(count * PI / 6 / 0.3)
        val settings = listOf(
            "particles.count=$count",
            "box.lengths=[$edge,$edge,$edge]",
            "seed=$seed",
            "velocities={\"type\":\"gaussian\",\"sigma\":1,\"exact\":true}",
        )
        val setup = ScenarioSetup.of(BuiltIn.scenario("elastic-gas", settings), "gas")
        val law = CollisionForcing(setup.restitution, setup.guard)
        Simulation(setup.population, setup.boundary, law, FixedTimeStep(0.1)).use { simulation ->
            val positions = listOf(0, 1, 2).map { Coordinate.Position(it) }
            val trajectories = Trajectories(positions, IntArray(count) { it })
            repeat(30) { simulation.advance() }
            repeat(TIMES) {
                trajectories.add(Snapshot.of(simulation.population, setup.boundary, simulation.step, simulation.time))
                repeat(2) { simulation.advance() }
            }
            val d = MeanSquareDisplacement(trajectories).diffusion(0, 1, 2)!!
            val more = FiniteCube.correction(1.0, FiniteCube.enskogViscosity(1.0, 1.0, 0.3, 1.0), edge)
            return d to d.value + more
        }
    }

    @Test
    fun `a small cube and a large one have different D, and one D∞`() {
        val small = List(6) { measured(108, it + 1) }
        val large = measured(2048, 1)
        val d = small.map { it.first.value }.average()
        val infinite = small.map { it.second }.average()
        val said = "D of 108 is $d, of 2048 ${large.first.value}; D∞ $infinite and ${large.second}"
        assertTrue(d < 0.93 * large.first.value) { said }
        assertEquals(1.0, infinite / large.second, 0.03) { said }
    }

    private companion object {
        const val TIMES = 128
    }
}
