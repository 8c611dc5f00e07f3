package daphnis.core.collision

import daphnis.core.FixedTimeStep
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.Kick
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.ConstantRoughness
import daphnis.core.surface.Roughness
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** Simulations of rough spheres. */
class RoughSimulationTest {
    private fun simulation(p: Population, roughness: Roughness?) = Simulation(
        p,
        Open,
        CollisionForcing(ConstantRestitution(1.0), roughness = roughness),
        FixedTimeStep(1.0),
    )

    @Test
    fun `rough spheres or walls without spins are refused, smooth ones keep theirs`() {
        val pair = populationOf(Sphere(x = -3.0, vx = 2.0), Sphere(x = 3.0, y = 0.5))
        val e = assertThrows(IllegalArgumentException::class.java) {
            simulation(pair.copy(), ConstantRoughness(0.0)).advance()
        }
        assertTrue("no angular velocities" in e.message!!) { e.message }
        val walls = Walls(Box.centred(20.0, 20.0, 20.0), roughness = List(6) { ConstantRoughness(0.0) })
        val smooth = CollisionForcing(ConstantRestitution(1.0))
        assertThrows(IllegalArgumentException::class.java) {
            Simulation(pair.copy(), walls, smooth, FixedTimeStep(1.0)).advance()
        }
        val w = doubleArrayOf(0.3, -0.7)
        val spinning = simulation(pair.withSpin(w, w, w), null)
        repeat(5) { spinning.advance() }
        assertEquals(1, spinning.collisions!!.counters.collisions)
        for (id in 0..1) assertEquals(w[id], spinning.population.wy[spinning.population.indexOf(id)])
    }

    @Test
    fun `a step that fails is taken back with the spins that a force has changed`() {
        val none = DoubleArray(2)
        val p = populationOf(Sphere(x = -3.0, vx = 2.0), Sphere(x = 3.0)).withSpin(none, none, none)
        val torque = Kick { population, _, duration -> for (k in 0 until 2) population.wz[k] += duration }
        var fails = true
        val output = Output { if (fails && it.step > 0) error("a test") }
        val forcing = CollisionForcing(ConstantRestitution(1.0))
        val simulation = Simulation(p, Open, forcing, FixedTimeStep(1.0), listOf(torque), listOf(output))
        assertThrows(IllegalStateException::class.java) { simulation.advance() }
        assertEquals(listOf(0.0, 0.0), simulation.population.wz.toList())
        fails = false
        simulation.advance()
        assertEquals(listOf(1.0, 1.0), simulation.population.wz.toList())
    }

    @Tag("thorough")
    @Test
    fun `perfectly rough spheres keep their energy over half a million collisions, and share it with their spins`() {
        val boundary = Periodic(Box.centred(10.0, 10.0, 10.0))
        val p = randomSpheres(400, boundary, 4, 1.0) { 0.5 }
        val zero = DoubleArray(p.size)
        val forcing = CollisionForcing(ConstantRestitution(1.0), roughness = ConstantRoughness(1.0))
        Simulation(p.withSpin(zero, zero, zero), boundary, forcing, FixedTimeStep(0.05)).use {
            val before = energies(it.population).sum()
            while (forcing.counters.collisions < 500_000) it.advance()
            val (moving, spinning) = energies(it.population)
            assertEquals(0.0, (moving + spinning) / before - 1, 1e-12)
            // Each of six degrees of freedom has a share; two thousand four hundred of them fluctuate by a few per cent.
            assertEquals(1.0, spinning / moving, 0.15)
        }
    }

    private fun energies(p: Population): List<Double> {
        var moving = 0.0
        var spinning = 0.0
        for (k in 0 until p.size) {
            moving += p.mass[k] / 2 * (p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k] + p.vz[k] * p.vz[k])
            val w2 = p.wx[k] * p.wx[k] + p.wy[k] * p.wy[k] + p.wz[k] * p.wz[k]
            spinning += 0.4 * p.mass[k] * p.radius[k] * p.radius[k] / 2 * w2
        }
        return listOf(moving, spinning)
    }
}
