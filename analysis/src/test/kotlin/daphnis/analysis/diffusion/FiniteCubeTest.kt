package daphnis.analysis.diffusion

import daphnis.analysis.theory.EnskogGas
import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.engine.CollisionForcing
import daphnis.core.format.Snapshot
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSetup
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.cbrt

class FiniteCubeTest {
    @Test
    fun `the correction is that worked out by hand`() {
        assertEquals(2.837297 * 3 / (6 * PI * 0.5 * 10), FiniteCube.correction(3.0, 0.5, 0.0, 7.0, 10.0), 1e-12)
        assertEquals(2.837297 * 3 / (6 * PI * 0.9 * 10), FiniteCube.correction(3.0, 0.5, 0.2, 2.0, 10.0), 1e-12)
    }

    /** Mean square displacements at φ = 0.3 and T = 1 of [count] spheres. */
    private fun displacements(count: Int, seed: Int): MeanSquareDisplacement {
        val edge = edge(count)
        val settings = listOf(
            "particles.count=$count",
            "box.lengths=[$edge,$edge,$edge]",
            "seed=$seed",
            "velocities={\"type\":\"gaussian\",\"sigma\":1,\"exact\":true}",
        )
        val setup = ScenarioSetup.of(BuiltIn.scenario("elastic-gas", settings), "gas")
        val law = CollisionForcing(setup.restitution, setup.guard)
        return Simulation(setup.population, setup.boundary, law, FixedTimeStep(0.2)).use { simulation ->
            val positions = listOf(0, 1, 2).map { Coordinate.Position(it) }
            val trajectories = Trajectories(positions, IntArray(count) { it })
            repeat(15) { simulation.advance() }
            repeat(TIMES) {
                trajectories.add(Snapshot.of(simulation.population, setup.boundary, simulation.step, simulation.time))
                simulation.advance()
            }
            MeanSquareDisplacement(trajectories)
        }
    }

    private fun edge(count: Int) = cbrt(count * PI / 6 / 0.3)

    /** D from lags 6 to 12, where the long memory of the fluid has died out, of [runs] runs. */
    private fun measured(count: Int, runs: Int): Double = (1..runs).map { seed ->
        val squares = displacements(count, seed)
        val mean = List(squares.lag.size) { l -> (0..2).sumOf { squares.mean(it)[l] } / 3 }
        (mean[59] - mean[29]) / (squares.lag[59] - squares.lag[29]) / 2
    }.average()

    @Tag("thorough")
    @Test
    fun `a small cube and a large one have different D, and one D∞`() {
        val small = measured(108, 10)
        val large = measured(500, 3)
        fun infinite(d: Double, count: Int) =
            d + FiniteCube.correction(1.0, EnskogGas.viscosity(1.0, 1.0, 0.3, 1.0), 1.8 / PI, d, edge(count))
        val said = "D of 108 is $small, of 500 $large; D∞ ${infinite(small, 108)} and ${infinite(large, 500)}"
        assertTrue(small < 0.95 * large) { said }
        assertEquals(1.0, infinite(small, 108) / infinite(large, 500), 0.03) { said }
    }

    private companion object {
        const val TIMES = 512
    }
}
