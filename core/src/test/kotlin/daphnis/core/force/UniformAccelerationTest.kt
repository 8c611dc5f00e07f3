package daphnis.core.force

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Walls
import daphnis.core.collision.CollisionRecord
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.math.BigDecimal
import java.math.MathContext

/**
 * What a uniform acceleration does to collisions: nothing to those of pairs, and those with walls are of parabolas.
 */
class UniformAccelerationTest {
    private fun fall(p: Population, boundary: BoundaryConditions, g: Double, dt: Double) = Simulation(
        p,
        boundary,
        CollisionForcing(ConstantRestitution(1.0), recordCollisions = true),
        FixedTimeStep(dt),
        listOf(UniformAcceleration(0.0, 0.0, -g)),
    )

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
    fun `a sphere bounces off the floor when its parabola meets it, however long the step`() {
        val g = 0.7
        val height = 3.0
        val v = 0.4
        for (dt in listOf(0.013, 0.2, 1.7, 9.0, 40.0)) {
            val p = populationOf(Sphere(z = -5.0 + 1.0 + height, vz = v, vx = 0.05))
            val simulation = fall(p, Walls(Box.centred(40.0, 40.0, 10.0)), g, dt)
            while (simulation.time < 300) simulation.advance()
            val exact = bounced(height, v, g, simulation.time)
            // A rounding at each bounce changes the moment of all later ones.
            assertEquals(exact.first, p.z[0] + 4.0, 1e-11) { "dt $dt" }
            assertEquals(exact.second, p.vz[0], 1e-11) { "dt $dt" }
            assertEquals(exact.third, simulation.collisions!!.counters.wallCollisions) { "dt $dt" }
        }
    }

    /** Height, speed and number of bounces at [time], with fifty digits. */
    private fun bounced(height: Double, v: Double, g: Double, time: Double): Triple<Double, Double, Long> {
        val digits = MathContext(50)
        val a = BigDecimal(g)
        val speed = (BigDecimal(v).pow(2) + BigDecimal(2) * a * BigDecimal(height)).sqrt(digits)
        val first = (BigDecimal(v) + speed).divide(a, digits)
        val period = (BigDecimal(2) * speed).divide(a, digits)
        val since = BigDecimal(time) - first
        if (since.signum() < 0) error("no bounce")
        val bounces = since.divideToIntegralValue(period)
        val t = since - bounces * period
        val at = speed * t - a * t * t / BigDecimal(2)
        return Triple(at.toDouble(), (speed - a * t).toDouble(), 1 + bounces.toLong())
    }

    @Test
    fun `a gas between walls keeps its energy over hundreds of bounces, whichever way it falls`() {
        for ((ax, ay, az) in listOf(Triple(0.0, 0.0, -0.1), Triple(0.2, -0.1, 0.15))) {
            for (dt in listOf(0.3, 3.0)) {
                val box = Walls(Box.centred(9.5, 9.5, 9.5))
                val p = randomSpheres(30, box, 2, 1.0) { 0.5 }
                p.mass.fill(1.0)
                val forces = listOf(UniformAcceleration(ax, ay, az))
                val forcing = CollisionForcing(ConstantRestitution(1.0))
                val simulation = Simulation(p, box, forcing, FixedTimeStep(dt), forces)
                fun total() = (0 until p.size).sumOf {
                    0.5 * (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it]) -
                        ax * p.x[it] - ay * p.y[it] - az * p.z[it] + 10.0
                }
                val before = total()
                while (forcing.counters.wallCollisions < 300 * p.size) simulation.advance()
                assertEquals(before, total(), 1e-12 * before) { "dt $dt" }
            }
        }
    }

    @Test
    fun `accelerations of several forces add up`() {
        val p = populationOf(Sphere(z = -2.0, vz = 0.0))
        val half = UniformAcceleration(0.0, 0.0, -0.35)
        val forcing = CollisionForcing(ConstantRestitution(1.0))
        val forces = listOf(half, half)
        Simulation(p, Walls(Box.centred(40.0, 40.0, 10.0)), forcing, FixedTimeStep(30.0), forces).advance()
        assertEquals(bounced(2.0, 0.0, 0.7, 30.0).first, p.z[0] + 4.0, 1e-12)
    }

    @Test
    fun `a grain that comes to rest on the floor does not end the run, and stays there`() {
        for (restitution in listOf(0.0, 0.05, 0.6, 0.99)) {
            val g = 1.0
            val dt = 0.5
            val p = populationOf(Sphere(z = -3.0))
            val walls = Walls(Box.centred(40.0, 40.0, 10.0), restitution)
            val simulation = fall(p, walls, g, dt)
            // The last bounce is over after twice the time of fall over 1 − ε.
            while (simulation.time < 5 / (1 - restitution)) simulation.advance()
            val rattling = dt * g / 16
            var highest = 0.0
            val before = simulation.collisions!!.counters.wallCollisions
            repeat(100) {
                simulation.advance()
                highest = maxOf(highest, p.z[0] + 4.0)
                assertTrue(p.z[0] + 4.0 > -1e-12) { "in the floor at ${p.z[0]}" }
            }
            assertTrue(highest <= rattling * rattling / (2 * g) * 1.001) { "restitution $restitution: up to $highest" }
            assertTrue(simulation.collisions!!.counters.wallCollisions - before <= 100 * 17)
        }
    }
}
