package daphnis.core.physics

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Periodic
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.population.SpinSums
import daphnis.core.surface.ConstantRoughness
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Rough spheres. The ratio of temperatures of a dilute gas that cools is that of Boltzmann's equation, solved by direct
 * simulation Monte Carlo; theory with Maxwellian velocities (Huthmann & Zippelius 1997, Phys. Rev. E 56, R6275) has
 * .574, .867, 1.447 and 2.060.
 */
@Tag("physics")
class RoughGasTest {
    private class Target(val e: Double, val beta: Double, val ratio: Double)

    private val targets = listOf(
        Target(0.9, 0.0, 0.5475),
        Target(0.9, 0.5, 0.857),
        Target(0.8, -0.5, 1.309),
        Target(0.5, 0.0, 1.902),
    )

    private fun simulation(count: Int, filling: Double, seed: Long, target: Target): Simulation {
        val box = cube(count, filling)
        val random = SeededRandom(1000 + seed)

        // I = 1/10 for spheres of diameter and mass 1.
        fun spins() = DoubleArray(count) { sqrt(10 * target.ratio) * random.nextGaussian() }
        val p = gas(count, box, seed, false).withSpin(spins(), spins(), spins())
        val forcing = CollisionForcing(ConstantRestitution(target.e), roughness = ConstantRoughness(target.beta))
        return Simulation(p, Periodic(box), forcing, FixedTimeStep(1.0))
    }

    private fun rotation(p: Population) = SpinSums().also { it.take(p) }.temperature

    /** Hard spheres have no scale of time: slower ones do the same later. */
    private fun restart(p: Population) {
        val factor = 1 / sqrt(temperature(p))
        for (column in listOf(p.vx, p.vy, p.vz, p.wx, p.wy, p.wz)) for (k in column.indices) column[k] *= factor
    }

    @Test
    fun `a dilute rough gas that cools keeps its ratio of temperatures`() {
        for (target in targets) {
            var rotating = 0.0
            var moving = 0.0
            for (seed in if (fullPhysics) 1L..8L else 1L..2L) {
                val simulation = simulation(8000, 0.01, seed, target)
                fun each() = 2.0 * simulation.collisions!!.counters.collisions / 8000
                while (each() < 100) {
                    simulation.advance()
                    val p = simulation.population
                    if (each() > 20) {
                        rotating += rotation(p) / temperature(p)
                        moving++
                    }
                    restart(p)
                }
            }
            assertPhysics("T_rot/T_tr, α = ${target.e}, β = ${target.beta}", target.ratio, rotating / moving, 0.01)
        }
    }

    @Test
    fun `perfectly rough elastic spheres keep their energy and share it equally`() {
        val simulation = simulation(2000, 0.1, 1, Target(1.0, 1.0, 0.2))
        fun energy() = simulation.population.let { 3 * (temperature(it) + rotation(it)) }
        val before = energy()
        val collisions = if (fullPhysics) 10_000_000L else 500_000L
        var rotating = 0.0
        var moving = 0.0
        while (simulation.collisions!!.counters.collisions < collisions) {
            simulation.advance()
            if (simulation.collisions!!.counters.collisions < collisions / 5) continue
            rotating += rotation(simulation.population)
            moving += temperature(simulation.population)
        }
        assertBelow("|ΔE/E|, rough, after $collisions collisions", abs(energy() / before - 1), 1e-12)
        assertPhysics("T_rot/T_tr, α = 1, β = 1", 1.0, rotating / moving, 0.01)
    }
}
