package daphnis.core.physics

import daphnis.core.Simulation
import daphnis.core.engine.CollisionForcing
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSetup
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

/**
 * Section 7 of the validation targets: the systems of Lewis & Massingill. The speeds are across the flow, (⟨v_y² +
 * v_z²⟩/2)^½.
 */
@Tag("physics")
@Tag("thorough")
class PaperSystemsTest {
    @Test
    fun `collisions and speeds of the paper's systems at the start and after 30 time units`() {
        measure("paper-figure-1", 0.068, 0.031, 0.0130)
        if (fullPhysics) measure("paper-figure-2", 0.40, 0.080, 0.0057)
    }

    private fun measure(name: String, first: Double, last: Double, speed: Double) {
        val setup = ScenarioSetup.of(BuiltIn.scenario(name), name)
        val forcing = CollisionForcing(setup.restitution, setup.guard)
        val simulation = Simulation(setup.population, setup.boundary, forcing, setup.timeStep)
        fun rate(): Double {
            val before = forcing.counters.collisions
            repeat(STEPS) { simulation.advance() }
            return 2.0 * (forcing.counters.collisions - before) / setup.population.size / STEPS
        }
        assertPhysics("collisions/particle/step, t = 0, $name", first, rate(), 0.06)
        while (simulation.step < 300 - STEPS) simulation.advance()
        assertPhysics("collisions/particle/step, t = 30, $name", last, rate(), 0.06)
        val p = setup.population
        var square = 0.0
        for (k in 0 until p.size) square += p.vy[k] * p.vy[k] + p.vz[k] * p.vz[k]
        assertPhysics("rms component speed, t = 30, $name", speed, sqrt(square / p.size / 2), 0.04)
    }

    private companion object {
        const val STEPS = 3
    }
}
