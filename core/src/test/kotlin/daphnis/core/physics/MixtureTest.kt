package daphnis.core.physics

import daphnis.core.Simulation
import daphnis.core.population.MaterialSums
import daphnis.core.population.PopulationSums
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSetup
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

/**
 * Partial temperatures of the built-in scenario `mixture`: masses 8 : 1, diameters 2 : 1, as many heavy spheres as light
 * ones (x₁ = 1/2), filling factor 0.1. Garzó & Dufty 1999 (Phys. Rev. E 60, 5706) find T₁/T₂, heavy over light, from
 * equal cooling rates of both kinds in the Enskog equation, with Maxwellian velocities.
 */
@Tag("physics")
class MixtureTest {
    /** Mean of T_heavy/T_light from [from] until [until] collisions per sphere. */
    private fun ratio(seed: Long, from: Double, until: Double, vararg settings: String): Double {
        val setup = ScenarioSetup.of(BuiltIn.scenario("mixture", settings.toList() + "seed=$seed"), "mixture")
        val sums = PopulationSums(null)
        val materials = MaterialSums(setup.population.materials)
        var sum = 0.0
        var samples = 0
        Simulation(setup.population, setup.boundary, setup.collisions(), setup.timeStep).use {
            fun each() = 2.0 * it.collisions!!.counters.collisions / it.population.size
            while (each() < until) {
                it.advance()
                if (each() < from || it.step % EVERY != 0L) continue
                sums.take(it.population)
                materials.take(it.population, sums)
                sum += materials.temperature(0) / materials.temperature(1)
                samples++
            }
        }
        return sum / samples
    }

    private fun hold(what: String, target: Double, bound: Double, ratios: List<Double>) {
        val mean = ratios.average()
        val error = sqrt(ratios.sumOf { (it - mean) * (it - mean) } / ratios.size / (ratios.size - 1))
        println("$what: $mean ± $error, ${ratios.size} seeds")
        assertPhysics(what, target, mean, bound)
    }

    @Tag("thorough")
    @Test
    fun `heavy spheres of a mixture that cools keep more energy than light ones`() {
        val seeds = if (fullPhysics) 1L..16L else 1L..4L
        val bound = if (fullPhysics) 0.01 else 0.02
        hold("T₁/T₂, mixture, e = 0.9", 1.169, bound, seeds.map { ratio(it, 10.0, 45.0) })
    }

    @Test
    fun `elastic spheres come to the same temperature, though they begin with the same speeds`() {
        val seeds = if (fullPhysics) 1L..8L else 1L..3L
        val bound = if (fullPhysics) 0.015 else 0.03
        val settings = arrayOf("restitution.coefficient=1", """velocities={"type": "gaussian", "sigma": 1}""")
        hold("T₁/T₂, mixture, e = 1", 1.0, bound, seeds.map { ratio(it, 20.0, 45.0, *settings) })
    }

    private companion object {
        const val EVERY = 5L
    }
}
