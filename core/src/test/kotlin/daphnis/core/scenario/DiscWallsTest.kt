package daphnis.core.scenario

import daphnis.core.Simulation
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

/** Discs between walls that move or are thermal. */
class DiscWallsTest {
    private fun setup(faces: String, vararg settings: String) = ScenarioSetup.of(
        ScenarioJson.parse(
            """{
              "dimensions": 2, "box": { "lengths": [8, 8] },
              "boundary": { "type": "walls", "axes": "xy", "faces": { $faces } },
              "particles": { "count": 16, "sizes": { "type": "equal", "radius": 0.4 } },
              "velocities": { "type": "gaussian", "sigma": 1 },
              "restitution": { "type": "constant", "coefficient": 1 },
              "timeStep": { "type": "fixed", "dt": 0.5 }, "until": 500
            }""",
            "discs",
            settings.toList(),
        ),
        "discs",
    )

    @Test
    fun `discs stay in the plane, and take the temperature of thermal walls`() {
        val thermal = """{ "temperature": 2.5 }"""
        val faces = listOf("lowerX", "upperX", "lowerY", "upperY").joinToString { """"$it": $thermal""" }
        val means = (1..4).map { seed ->
            val setup = setup(faces, "seed=$seed", "particles.mass=1")
            Simulation(setup.population, setup.boundary, setup.collisions(), setup.timeStep).use { simulation ->
                val p = simulation.population
                while (simulation.time < 20) simulation.advance()
                var sum = 0.0
                repeat(1000) {
                    simulation.advance()
                    for (k in 0 until p.size) sum += 0.5 * (p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k]) / p.size
                }
                for (none in listOf(p.z, p.vz)) assertTrue(none.all { it.toRawBits() == 0L })
                sum / 1000
            }
        }
        val mean = means.average()
        val error = sqrt(means.sumOf { (it - mean) * (it - mean) } / 12)
        assertTrue(error < 0.1) { "error $error" }
        assertTrue(abs(mean - 2.5) < 4 * error + 0.005) { "$mean ± $error" }
    }

    @Test
    fun `discs start between walls that move, on a lattice too`() {
        val motion = """"lowerX": { "motion": { "type": "sine", "amplitude": 0.5, "frequency": 1, "phase": 0.25 } }"""
        for (placement in listOf("""{ "type": "random" }""", """{ "type": "lattice", "lattice": "square" }""")) {
            val setup = setup(motion, "placement=$placement")
            assertTrue(setup.population.x.min() >= -3.5 + 0.4)
            Simulation(setup.population, setup.boundary, setup.collisions(), setup.timeStep).use { simulation ->
                repeat(20) { simulation.advance() }
                val p = simulation.population
                assertEquals(
                    listOf(0L, 0L),
                    listOf(p.z, p.vz).map { no ->
                        no.fold(0L) { all, z -> all or z.toRawBits() }
                    },
                )
            }
        }
    }
}
