package daphnis.core.run

import daphnis.core.Engines
import daphnis.core.FixedTimeStep
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.cluster.RowCase
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.Population
import daphnis.core.population.PopulationSums
import daphnis.core.randomSpheres
import daphnis.core.scenario.ScenarioJson
import daphnis.core.simulationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class HeatStatisticsTest {
    /** Σ r_a (½ m v²) over all. */
    private fun moment(p: Population, axis: Int) = (0 until p.size).sumOf { k ->
        val v2 = p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k] + p.vz[k] * p.vz[k]
        p.position(axis)[k] * 0.5 * p.mass[k] * v2
    }

    @Test
    fun `what collisions carry and spheres carry between them moves the energy, whichever sphere is named first`() {
        for (ids in listOf(intArrayOf(0, 1), intArrayOf(1, 0))) {
            val x = doubleArrayOf(-1.0, 1.0)
            val y = doubleArrayOf(0.25, -0.125)
            val vx = doubleArrayOf(1.5, -0.25)
            val vy = doubleArrayOf(0.125, 0.375)
            val p = Population.builder().positions(x, y, y).velocities(vx, vy, vy).radii(doubleArrayOf(0.5, 0.75))
                .masses(doubleArrayOf(1.0, 3.0)).ids(ids).build()
            val before = p.copy()
            val forcing = CollisionForcing(ConstantRestitution(1.0), recordCollisions = true)
            val heat = HeatStatistics()
            Simulation(p, Open, forcing, FixedTimeStep(1.0)).use {
                it.advance()
                heat.write(it)
                val record = forcing.record!!
                assertEquals(1, record.size)
                val contact = record.time[0]
                for (axis in 0..2) {
                    val flown = flux(before, axis) * contact + flux(it.population, axis) * (1 - contact)
                    val moved = moment(it.population, axis) - moment(before, axis)
                    assertEquals(moved, flown + heat.carried(axis), 1e-13)
                    assertTrue(heat.carried(axis) != 0.0)
                }
            }
        }
    }

    /** Σ v_a (½ m v²). */
    private fun flux(p: Population, axis: Int) = (0 until p.size).sumOf { k ->
        val v2 = p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k] + p.vz[k] * p.vz[k]
        p.velocity(axis)[k] * 0.5 * p.mass[k] * v2
    }

    @Test
    fun `sums over particles are of the motion around their mean, of equal bits in parts`() {
        val boundary = Periodic(Box.centred(12.0, 12.0, 12.0))
        val p = randomSpheres(300, boundary, 3, 1.0) { 0.5 }
        for (k in 0 until p.size) p.vx[k] += 2.0
        val sums = PopulationSums(null, carriesHeat = true).apply { take(p) }
        val v = (0..2).map { axis -> DoubleArray(p.size) { p.velocity(axis)[it] - sums.mean[axis] } }
        for (axis in 0..2) {
            val expected = (0 until p.size).sumOf { k ->
                0.5 * p.mass[k] * v[axis][k] * (v[0][k] * v[0][k] + v[1][k] * v[1][k] + v[2][k] * v[2][k])
            }
            assertEquals(expected, sums.heat[axis], 1e-10)
            assertTrue(sums.heat[axis] != 0.0)
        }
        val none = PopulationSums(null).apply { take(p) }
        assertEquals(listOf(0.0, 0.0, 0.0), none.heat.asList())
        assertEquals(none.kinetic.asList(), sums.kinetic.asList())
    }

    @Test
    fun `all engines write the same heat, and a gas that is not elastic writes none`(@TempDir home: Path) {
        fun rows(name: String, vararg settings: String): List<String> {
            val scenario = ScenarioJson.parse(
                RowCase.AT_REST.text,
                "test",
                listOf("output.transportEvery=1") + settings,
            )
            Run.start(scenario, "test", home.resolve(name)).use { it.execute() }
            return Files.readAllLines(home.resolve(name).resolve("transport.csv"))
        }
        val serial = rows("serial", "engine.name=serial")
        assertTrue("collisional_heat_z" in serial[0])
        assertTrue(serial.last().split(',').takeLast(6).all { it.toDouble() != 0.0 })
        for (engine in Engines.names - "serial") {
            assertEquals(serial, rows(engine, "engine.name=$engine", "engine.threads=3")) { engine }
        }
        assertTrue("heat" !in rows("inelastic", "restitution.coefficient=0.9")[0])
    }

    @Test
    fun `sums that are saved and restored go on with the same bits`() {
        val boundary = Periodic(Box.centred(12.0, 12.0, 12.0))
        val simulation =
            simulationOf(randomSpheres(400, boundary, 3, 1.0) { 0.5 }, boundary, 0.2, ConstantRestitution(1.0))
        val whole = HeatStatistics()
        var resumed = HeatStatistics()
        repeat(30) {
            simulation.advance()
            whole.write(simulation)
            resumed.write(simulation)
            resumed.write(simulation)
            val state = OutputState("heat")
            resumed.save(state)
            resumed = HeatStatistics().apply { restore(state) }
        }
        for (axis in 0..2) assertEquals(whole.carried(axis), resumed.carried(axis))
        assertTrue((0..2).all { whole.carried(it) != 0.0 })
    }
}
