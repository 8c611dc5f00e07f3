package daphnis.core.physics

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Periodic
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
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

    /** Temperature of what three columns say, at mass 1. */
    private fun temperature(factor: Double, x: DoubleArray, y: DoubleArray, z: DoubleArray): Double {
        var sum = 0.0
        for (k in x.indices) sum += x[k] * x[k] + y[k] * y[k] + z[k] * z[k]
        return factor * sum / x.size / 3
    }

    private fun rotation(p: Population) = temperature(0.1, p.wx, p.wy, p.wz)

    private fun motion(p: Population) = temperature(1.0, p.vx, p.vy, p.vz)

    /** Hard spheres have no scale of time: slower ones do the same later. */
    private fun restart(p: Population) {
        val factor = 1 / sqrt(motion(p))
        for (column in listOf(p.vx, p.vy, p.vz, p.wx, p.wy, p.wz)) for (k in column.indices) column[k] *= factor
    }

    @Test
    fun `a dilute rough gas that cools keeps its ratio of temperatures`() {
        val count = if (fullPhysics) 8000 else 4000
        val until = if (fullPhysics) 100.0 else 60.0
        val bound = if (fullPhysics) 0.01 else 0.03
        for (target in targets) {
            var rotating = 0.0
            var moving = 0.0
            for (seed in if (fullPhysics) 1L..8L else 1L..1L) {
                val simulation = simulation(count, 0.01, seed, target)
                fun each() = 2.0 * simulation.collisions!!.counters.collisions / count
                while (each() < until) {
                    simulation.advance()
                    val p = simulation.population
                    if (each() > 20) {
                        rotating += rotation(p) / motion(p)
                        moving++
                    }
                    restart(p)
                }
            }
            assertPhysics("T_rot/T_tr, α = ${target.e}, β = ${target.beta}", target.ratio, rotating / moving, bound)
        }
    }

    @Test
    fun `perfectly rough elastic spheres keep their energy and share it equally`() {
        val simulation = simulation(2000, 0.1, 1, Target(1.0, 1.0, 0.2))
        fun energy() = simulation.population.let { motion(it) + rotation(it) }
        val before = energy()
        val collisions = if (fullPhysics) 10_000_000L else 500_000L
        var rotating = 0.0
        var moving = 0.0
        while (simulation.collisions!!.counters.collisions < collisions) {
            simulation.advance()
            if (simulation.collisions!!.counters.collisions < collisions / 5) continue
            rotating += rotation(simulation.population)
            moving += motion(simulation.population)
        }
        assertBelow("|ΔE/E|, rough, after $collisions collisions", abs(energy() / before - 1), 1e-12)
        assertPhysics("T_rot/T_tr, α = 1, β = 1", 1.0, rotating / moving, 0.01)
    }
}
