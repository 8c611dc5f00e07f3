package daphnis.core.physics

import daphnis.core.Simulation
import daphnis.core.cluster.bricks.BrickDivision
import daphnis.core.cluster.bricks.BricksTogether
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.engine.threadpool.ThreadPoolEngine
import daphnis.core.parallel.FixedPool
import daphnis.core.population.stateDigest
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

/** A thermal plane that makes an acute corner with a floor, which sends spheres straight back to it. */
@Timeout(120)
class ThermalCornerTest {
    private fun setup(count: Int, seed: Int): ScenarioSetup = ScenarioSetup.of(
        ScenarioJson.parse(
            """{
              "seed": $seed, "box": {"lengths": [8, 8, 8]},
              "boundary": {"type": "walls", "axes": "xyz", "faces": {"lowerZ": {"restitution": 0}},
                "surfaces": [{"type": "plane", "point": [2, 0, 0], "normal": [-1, 0, -0.1], "temperature": 1}]},
              "particles": {"count": $count, "sizes": {"type": "equal", "radius": 0.35}},
              "velocities": {"type": "gaussian", "sigma": 1, "zeroMomentum": false},
              "restitution": {"type": "constant", "coefficient": 1},
              "guard": {"type": "contact-duration", "duration": 0.05},
              "timeStep": {"type": "fixed", "dt": 0.1}, "until": 2000
            }""",
            "corner",
            emptyList(),
        ),
        "corner",
    )

    private fun run(setup: ScenarioSetup, end: Double, engine: CollisionEngine): Simulation {
        engine.use {
            val simulation = Simulation(
                setup.population,
                setup.boundary,
                setup.collisions(it),
                setup.timeStep,
                setup.forces,
            )
            while (simulation.time < end) simulation.advance()
            return simulation
        }
    }

    @Test
    fun `a sphere that comes straight back gets another velocity, so it gets out, with the bits of every engine`() {
        val ends = listOf(
            SerialEngine(),
            ThreadPoolEngine(2),
            IslandsEngine(FixedPool(2), fewest = 0),
            HorizonEngine(FixedPool(2), fewest = 0, tuning = HorizonTuning(3)),
            BricksTogether(FixedPool(2), BrickDivision(2, 2, 2)),
        ).map { stateDigest(run(setup(60, SEED), END, it).population) }
        assertEquals(List(ends.size) { ends[0] }, ends)
    }

    private companion object {
        /** With one velocity for all impacts at a time, this collapses at time 13.8. */
        const val SEED = 3
        const val END = 16.0
    }
}
