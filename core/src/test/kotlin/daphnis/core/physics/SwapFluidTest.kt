package daphnis.core.physics

import daphnis.core.Simulation
import daphnis.core.population.Population
import daphnis.core.run.CollisionStatistics
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

/** Swaps of places change no pressure, and make a dense fluid forget sooner where its particles were. */
@Tag("physics")
class SwapFluidTest {
    private fun simulation(setup: ScenarioSetup, statistics: CollisionStatistics? = null) = Simulation(
        setup.population,
        setup.boundary,
        setup.collisions(recordCollisions = statistics != null),
        setup.timeStep,
        outputs = listOfNotNull(statistics),
    )

    private fun setup(text: String, swaps: String, state: Population? = null) =
        ScenarioSetup.of(ScenarioJson.parse(text, "swaps", listOf("swaps=$swaps")), "swaps", state)

    /** Z of 250 spheres of each of the diameters 1 and 1.4, at a filling factor of 0.5. */
    private fun compressibility(swaps: String): Double {
        val setup = setup(BINARY, swaps)
        val (settle, end) = if (fullPhysics) 20.0 to 120.0 else 5.0 to 25.0
        val statistics = CollisionStatistics(from = settle)
        simulation(setup, statistics).use {
            while (it.time < end) it.advance()
            val counters = it.collisions!!.counters
            assertTrue(counters.swaps > 0 == (swaps != "null"))
            // T is 1, and that of N − 1 free spheres.
            val virial = (statistics.virial[0] + statistics.virial[4] + statistics.virial[8]) / 3 / (it.time - settle)
            return 1 + virial / it.population.size
        }
    }

    @Test
    fun `a mixture of 1 to 1,4 has the pressure of Boublik and Mansoori, with swaps and without`() {
        // Accurate to half a percent there; the rest is chance.
        val bound = if (fullPhysics) 0.008 else 0.015
        for (swaps in listOf("null", """{"rate": 100}""")) {
            assertPhysics("Z, 1 : 1.4, φ = 0.5, swaps $swaps", 12.3176, compressibility(swaps), bound)
        }
    }

    /** A fluid that swaps have brought to equilibrium, as it would not be so soon without. */
    private fun settled() = setup(POLYDISPERSE, SWAPS).let { setup ->
        simulation(setup).use { while (it.time < 50) it.advance() }
        setup.population
    }

    /**
     * The part of spheres of [start] that are no farther than 0.3 mean diameters from where they were 20 units of time
     * before.
     */
    private fun overlap(start: Population, swaps: String): Double {
        val setup = setup(POLYDISPERSE, swaps, start.copy())
        val p = setup.population
        val reach = 0.6 * p.radius.average()
        val edge = setup.boundary.box.length(0)
        fun places() = DoubleArray(3 * p.size) {
            val k = p.indexOf(it / 3)
            p.position(it % 3)[k] + p.boxesCrossed(it / 3, it % 3) * edge
        }
        val seen = ArrayList<DoubleArray>()
        simulation(setup).use {
            for (time in 0..(if (fullPhysics) 200 else 30)) {
                while (it.time < time - 1e-6) it.advance()
                seen += places()
            }
        }
        fun near(a: DoubleArray, b: DoubleArray) = (0 until p.size).count { k ->
            sqrt((0..2).sumOf { (a[3 * k + it] - b[3 * k + it]) * (a[3 * k + it] - b[3 * k + it]) }) <= reach
        }
        return (0 until seen.size - LAG).map { near(seen[it], seen[it + LAG]) }.average() / p.size
    }

    @Test
    fun `a polydisperse fluid at 0,58 forgets where its spheres were sooner with swaps`() {
        val start = settled()
        val plain = overlap(start, "null")
        val swapped = overlap(start, SWAPS)
        // Means of four seeds of 300 units of time are 0.44 ± 0.02 and 0.357 ± 0.012.
        val bound = if (fullPhysics) 0.07 else 0.12
        assertPhysics("Q(20), polydisperse, φ = 0.58", 0.44, plain, bound, relative = false)
        assertPhysics("Q(20), swaps of 20 per sphere and time", 0.357, swapped, bound, relative = false)
        assertTrue(swapped < plain - 0.04) { "$swapped with swaps, $plain without" }
    }

    private companion object {
        const val LAG = 20
        const val SWAPS = """{"rate": 20}"""
        const val GAS = """"boundary": {"type": "periodic"}, "placement": {"type": "grown"},
            "velocities": {"type": "gaussian", "temperature": 1, "exact": true}, "until": 1000,
            "restitution": {"type": "constant", "coefficient": 1}, "timeStep": {"type": "fixed", "dt": 0.05}"""
        const val BINARY = """{"box": {"lengths": [7.946785, 7.946785, 7.946785]}, "particles": {"materials": [
            {"name": "small", "count": 250, "mass": 1, "sizes": {"type": "equal", "radius": 0.4}},
            {"name": "large", "count": 250, "mass": 1, "sizes": {"type": "equal", "radius": 0.56}}]}, $GAS}"""
        const val POLYDISPERSE = """{"box": {"lengths": [8, 8, 8]}, "particles": {"fillingFactor": 0.58, "mass": 1,
            "sizes": {"type": "power-law", "exponent": 3, "minimum": 0.36, "maximum": 0.8}}, $GAS}"""
    }
}
