package daphnis.core.run

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.collision.NoGuard
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.ConstantRoughness
import daphnis.core.surface.CoulombRoughness
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.math.BigDecimal

class CollisionStatisticsTest {
    private val boundary = Periodic(Box.centred(12.0, 12.0, 12.0))
    private val gas = randomSpheres(400, boundary, 3, 1.0) { 0.5 }

    private fun simulation() = simulationOf(gas.copy(), boundary, 0.2, ConstantRestitution(0.8))

    private fun numbers(s: CollisionStatistics) =
        listOf(s.count.toDouble(), s.sumSpeed, s.sumSpeedSquared, s.dissipated) + s.virial.asList() + s.sums()

    @Test
    fun `sums are those of all collisions, rounded once`() {
        val statistics = CollisionStatistics()
        val simulation = simulation()
        var speed = BigDecimal.ZERO
        var squared = BigDecimal.ZERO
        repeat(20) {
            simulation.advance()
            statistics.write(simulation)
            val record = simulation.collisions!!.record!!
            for (k in 0 until record.size) {
                speed += BigDecimal(record.impactSpeed(k))
                squared += BigDecimal(record.impactSpeed(k) * record.impactSpeed(k))
            }
        }
        assertTrue(statistics.count > 1000)
        assertEquals(speed.toDouble(), statistics.sumSpeed)
        assertEquals(squared.toDouble(), statistics.sumSpeedSquared)
    }

    @Test
    fun `rough spheres lose what the sums say, in spins too, and carry the momentum of their surfaces`() {
        val box = Periodic(Box.centred(12.0, 12.0, 12.0))
        val p = randomSpheres(400, box, 3, 1.0) { 0.3 + 0.2 * it.nextDouble() }
        val w = DoubleArray(p.size) { 0.01 * it - 2.0 }
        val law = CoulombRoughness(0.3, 0.5)
        val forcing = CollisionForcing(ConstantRestitution(0.8), recordCollisions = true, roughness = law)
        val statistics = CollisionStatistics()
        Simulation(p.withSpin(w, w, w), box, forcing, FixedTimeStep(0.1)).use {
            val before = energy(it.population)
            repeat(60) { _ ->
                it.advance()
                statistics.write(it)
            }
            assertTrue(statistics.count > 500)
            assertEquals(before - energy(it.population), statistics.dissipated, 1e-11 * before)
        }
    }

    /** Of motion and of the spins of solid spheres. */
    private fun energy(p: Population) = (0 until p.size).sumOf { k ->
        val motion = p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k] + p.vz[k] * p.vz[k]
        val spin = p.wx[k] * p.wx[k] + p.wy[k] * p.wy[k] + p.wz[k] * p.wz[k]
        0.5 * p.mass[k] * (motion + 0.4 * p.radius[k] * p.radius[k] * spin)
    }

    @Test
    fun `the momentum of surfaces is in the virial, whichever sphere is named first`() {
        for (ids in listOf(intArrayOf(0, 1), intArrayOf(1, 0))) {
            val w = doubleArrayOf(0.4, -0.9)
            val x = doubleArrayOf(-1.0, 1.0)
            val y = doubleArrayOf(0.25, -0.125)
            val v = doubleArrayOf(1.0, -0.5)
            val p = Population.builder().positions(x, y, y).velocities(v, y, y).radii(doubleArrayOf(0.5, 0.75))
                .masses(doubleArrayOf(1.0, 3.0)).ids(ids).spins(w, v, y).build()
            val before = p.copy()
            val law = ConstantRoughness(0.5)
            val forcing = CollisionForcing(ConstantRestitution(0.8), recordCollisions = true, roughness = law)
            val statistics = CollisionStatistics()
            Simulation(p, Open, forcing, FixedTimeStep(1.0)).use {
                it.advance()
                statistics.write(it)
                val k = it.population.indexOf(1)
                val from = before.indexOf(1)
                val record = forcing.record!!
                assertEquals(1, record.size)
                for (a in 0..2) {
                    for (b in 0..2) {
                        val change = it.population.velocity(a)[k] - before.velocity(a)[from]
                        val expected = before.mass[from] * change * record.separation(0, b)
                        assertEquals(expected, statistics.virial[a * 3 + b], 1e-14)
                    }
                }
            }
        }
    }

    @Test
    fun `smooth spheres have nothing of the surfaces of rough ones that the engine had before`() {
        val engine = SerialEngine()
        val none = DoubleArray(2)
        val pair = populationOf(Sphere(x = -1.0, vx = 2.0), Sphere(x = 1.0, y = 0.5)).withSpin(none, none, none)
        for (roughness in listOf(ConstantRoughness(0.5), null)) {
            val forcing =
                CollisionForcing(
                    ConstantRestitution(0.8),
                    NoGuard,
                    engine,
                    recordCollisions = true,
                    roughness = roughness,
                )
            Simulation(pair.copy(), Open, forcing, FixedTimeStep(1.0)).advance()
            val record = forcing.record!!
            assertEquals(1, record.size)
            assertEquals(roughness != null, record.tangentialImpulse(0, 1) != 0.0)
            assertEquals(roughness != null, record.surfaceDissipation(0) != 0.0)
        }
    }

    @Test
    fun `sums that are written down and taken up again end with the same bits as those kept in one go`() {
        val whole = CollisionStatistics()
        var resumed = CollisionStatistics()
        var rounded = CollisionStatistics()
        val simulation = simulation()
        repeat(40) {
            simulation.advance()
            for (s in listOf(whole, resumed, rounded)) s.write(simulation)
            resumed = again(resumed.sums(), resumed.speeds)
            // As a checkpoint of an earlier version has it.
            rounded = again(rounded.sums().take(13), rounded.speeds)
        }
        assertEquals(numbers(whole), numbers(resumed))
        assertNotEquals(numbers(whole), numbers(rounded)) { "what is left of rounding matters" }
        for ((a, b) in numbers(whole).zip(numbers(rounded)).take(13)) assertEquals(a, b, 1e-9)
    }

    private fun again(sums: List<Double>, speeds: LongArray) =
        CollisionStatistics().apply { restore(sums, speeds.copyOf()) }

    @Test
    fun `what are no sums is refused`() {
        val speeds = CollisionStatistics().speeds
        val sums = CollisionStatistics().sums()
        val wrongPairs = listOf(12.0, -1.0, 0.5).map { sums + listOf(it, 1.0) }
        for (bad in wrongPairs + listOf(sums.drop(1), sums + 1.0)) {
            assertThrows(IllegalArgumentException::class.java) { CollisionStatistics().restore(bad, speeds) }
        }
        assertThrows(IllegalArgumentException::class.java) { CollisionStatistics().restore(sums, LongArray(3)) }
    }
}
