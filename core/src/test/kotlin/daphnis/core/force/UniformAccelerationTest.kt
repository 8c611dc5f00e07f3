package daphnis.core.force

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Walls
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs

/**
 * What a uniform acceleration does to collisions: nothing to those of pairs, and at walls what docs/physics.md says.
 */
class UniformAccelerationTest {
    private fun fall(p: Population, boundary: BoundaryConditions, g: Double, dt: Double) = Simulation(
        p,
        boundary,
        CollisionForcing(ConstantRestitution(1.0), recordCollisions = true),
        FixedTimeStep(dt),
        listOf(UniformAcceleration(0.0, 0.0, -g)),
    )

    /** Kinetic and potential energy, by mass 1 each. */
    private fun energy(p: Population, g: Double): Double =
        (0 until p.size).sumOf { 0.5 * (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it]) + g * p.z[it] }

    @Test
    fun `pairs collide as without it, displaced by half g t squared, however long the step`() {
        val start = randomSpheres(60, Open, 4, 0.3) { 0.5 }
        for (k in 0 until start.size) {
            // Towards the centre, so that they do collide.
            start.vx[k] -= 0.8 * start.x[k]
            start.vy[k] -= 0.8 * start.y[k]
            start.vz[k] -= 0.8 * start.z[k]
        }
        val g = 20.0
        val dt = 0.5
        val floating = fall(start.copy(), Open, 0.0, dt)
        val falling = fall(start.copy(), Open, g, dt)
        var collisions = 0
        repeat(6) {
            floating.advance()
            falling.advance()
            val a = floating.collisions!!.record!!
            val b = falling.collisions!!.record!!
            collisions += a.size
            assertEquals(pairs(a), pairs(b))
            for (k in 0 until a.size) assertEquals(a.time[k], b.time[k], 1e-8)
            val t = floating.time
            for (id in 0 until start.size) {
                val p = floating.population
                val q = falling.population
                assertEquals(p.z[p.indexOf(id)] - 0.5 * g * t * t, q.z[q.indexOf(id)], 1e-7)
                assertEquals(p.vz[p.indexOf(id)] - g * t, q.vz[q.indexOf(id)], 1e-7)
                assertEquals(p.x[p.indexOf(id)], q.x[q.indexOf(id)], 1e-7)
            }
        }
        assertTrue(collisions > 60) { "only $collisions collisions" }
    }

    private fun pairs(record: CollisionRecord) = (0 until record.size).map { record.lower[it] to record.higher[it] }

    @Test
    fun `an elastic bounce off the floor gains g v (dt − 2 s) when it comes a time s into the step`() {
        val g = 0.5
        val dt = 0.2
        for (s in listOf(0.01, 0.05, 0.1, 0.17)) {
            val speed = 1.5 + g * dt / 2
            val p = populationOf(Sphere(z = -5.0 + 1.0 + speed * s, vz = -1.5))
            val before = energy(p, g)
            val simulation = fall(p, Walls(Box.centred(10.0, 10.0, 10.0)), g, dt)
            simulation.advance()
            assertEquals(1L, simulation.collisions!!.counters.wallCollisions)
            assertEquals(g * speed * (dt - 2 * s), energy(p, g) - before, 1e-12)
        }
    }

    @Test
    fun `a gas between walls gains about a fifth of the square of g dt over its thermal speed, a bounce across g`() {
        val g = 0.1
        val ratio = 0.3
        val p = randomSpheres(100, Walls(Box.centred(9.5, 9.5, 9.5)), 2, 1.0) { 0.5 }
        p.mass.fill(1.0)
        val floor = 9.5 / 2
        fun total() = energy(p, g) + g * floor * p.size
        val before = total()
        val simulation = fall(p, Walls(Box.centred(9.5, 9.5, 9.5)), g, ratio / g)
        while (simulation.collisions!!.counters.wallCollisions < 6000) simulation.advance()
        // A third of 60 bounces of each sphere are across g.
        val gain = (total() - before) / before / 20 / (ratio * ratio)
        assertTrue(abs(gain - 0.22) < 0.1) { "gain $gain" }
    }
}
