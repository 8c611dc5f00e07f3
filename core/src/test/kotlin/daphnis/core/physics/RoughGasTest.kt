package daphnis.core.physics

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.ConstantRoughness
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Rough spheres. The ratio of temperatures of a dilute gas that cools, or is driven, is that of Boltzmann's equation
 * ([RoughBoltzmann]).
 */
@Tag("physics")
class RoughGasTest {
    /** @property from collisions per sphere until the spins have forgotten that they were drawn as Gaussians */
    private fun simulation(count: Int, filling: Double, seed: Long, target: RoughBoltzmann.Target): Simulation {
        val box = cube(count, filling)
        val random = SeededRandom(1000 + seed)

        // I = 1/10 for spheres of diameter and mass 1.
        fun spins() = DoubleArray(count) { sqrt(10 * target.ratio) * random.nextGaussian() }
        val p = gas(count, box, seed, false).withSpin(spins(), spins(), spins())
        val forcing = CollisionForcing(ConstantRestitution(target.alpha), roughness = ConstantRoughness(target.beta))
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

    @Tag("thorough")
    @Test
    fun `a dilute rough gas that cools keeps its ratio of temperatures`() {
        val count = if (fullPhysics) 8000 else 4000
        val length = if (fullPhysics) 80.0 else 40.0
        val bound = if (fullPhysics) 0.01 else 0.03
        for (target in RoughBoltzmann.COOLING) {
            // Until the spins have forgotten that they were drawn as Gaussians: RoughBoltzmannTest.
            val from = if (target.beta < 0) 150 else 20
            var rotating = 0.0
            var moving = 0.0
            for (seed in if (fullPhysics) 1L..8L else 1L..1L) {
                val simulation = simulation(count, 0.01, seed, target)
                fun each() = 2.0 * simulation.collisions!!.counters.collisions / count
                while (each() < from + length) {
                    simulation.advance()
                    val p = simulation.population
                    if (each() > from) {
                        rotating += rotation(p) / motion(p)
                        moving++
                    }
                    restart(p)
                }
            }
            assertPhysics("T_rot/T_tr, α = ${target.alpha}, β = ${target.beta}", target.ratio, rotating / moving, bound)
        }
    }

    /** White noise that makes the temperature 1 again. */
    private fun drive(p: Population, random: SeededRandom) {
        val sigma = sqrt(maxOf(0.0, 1 - motion(p)))
        for (v in listOf(p.vx, p.vy, p.vz)) {
            for (k in v.indices) v[k] += sigma * random.nextGaussian()
            val mean = v.average()
            for (k in v.indices) v[k] -= mean
        }
    }

    /** A gas at φ = 0.01 without spins at the start, of which each state of the second half of a run is shown to [look]. */
    private fun driven(count: Int, beta: Double, until: Double, seed: Long, look: (Population) -> Unit) {
        val box = cube(count, 0.01)
        fun none() = DoubleArray(count)
        val p = gas(count, box, seed, false).withSpin(none(), none(), none())
        val forcing = CollisionForcing(ConstantRestitution(0.9), roughness = ConstantRoughness(beta))
        val simulation = Simulation(p, Periodic(box), forcing, FixedTimeStep(1.0))
        val random = SeededRandom(1000 + seed)
        while (2.0 * forcing.counters.collisions / count < until) {
            simulation.advance()
            drive(simulation.population, random)
            if (2.0 * forcing.counters.collisions / count > until / 2) look(simulation.population)
        }
    }

    @Test
    fun `a driven rough gas shares its energy with the spins`() {
        for (target in RoughBoltzmann.DRIVEN.filter { fullPhysics || it.beta > -0.6 }) {
            var rotating = 0.0
            var moving = 0.0
            for (seed in if (fullPhysics) 1L..3L else 1L..1L) {
                val until = if (target.beta < -0.6) 200.0 else 80.0
                driven(if (fullPhysics) 4000 else 1000, target.beta, until, seed) {
                    rotating += rotation(it)
                    moving += motion(it)
                }
            }
            val name = "E_rot/E_kin, driven, β = ${target.beta}"
            assertPhysics(name, target.ratio, rotating / moving, if (fullPhysics) 0.015 else 0.05)
        }
    }

    @Tag("thorough")
    @Test
    fun `perfectly rough elastic spheres keep their energy and share it equally`() {
        val simulation = simulation(2000, 0.1, 1, RoughBoltzmann.Target(1.0, 1.0, 0.2))
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
