package daphnis.core.potential

import daphnis.core.Engines
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.prepare
import daphnis.core.initial.ChainPlacement
import daphnis.core.initial.PlacementException
import daphnis.core.initial.SeededRandom
import daphnis.core.population.stateDigest
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

class ChainsTest {
    private fun setup(vararg settings: String): ScenarioSetup {
        val text = """{"box": {"lengths": [12, 12, 12]}, "boundary": {"type": "periodic"},
            "particles": {"count": 300, "sizes": {"type": "equal", "radius": 0.5}, "mass": 1},
            "velocities": {"type": "gaussian", "temperature": 1}, "bonds": {"length": 5, "greatest": 1.3, "least": 1.1},
            "restitution": {"type": "constant", "coefficient": 1}, "timeStep": {"type": "fixed", "dt": 0.1}, "until": 9}"""
        return ScenarioSetup.of(ScenarioJson.parse(text, "chains", settings.toList()), "chains")
    }

    private fun simulation(setup: ScenarioSetup, engine: String, threads: Int) = Simulation(
        setup.population,
        setup.boundary,
        setup.collisions(Engines.create(engine, threads)!!),
        setup.timeStep,
        setup.forces,
    )

    /** Distances of neighbours in chains over the sum of their radii. */
    private fun lengths(simulation: Simulation, length: Int): List<Double> {
        val p = simulation.population
        val images = Images().also { it.prepare(simulation.boundary, simulation.time) }
        return (0 until p.size).filter { it % length != length - 1 }.map { id ->
            val (k, j) = p.indexOf(id) to p.indexOf(id + 1)
            val d = DoubleArray(3) { p.position(it)[j] - p.position(it)[k] }
            images.toNearest(d)
            sqrt(d.sumOf { it * it }) / (p.radius[k] + p.radius[j])
        }
    }

    @Test
    fun `neighbours in chains stay between the least and the greatest distance, on every engine alike`() {
        val digests = listOf("serial" to 1, "islands" to 2, "thread-pool" to 2, "horizon" to 2).map { (name, threads) ->
            simulation(setup(), name, threads).use { simulation ->
                val energy = simulation.conserved().kineticEnergy
                assertEquals(240, lengths(simulation, 5).size)
                repeat(60) {
                    simulation.advance()
                    for (d in lengths(simulation, 5)) assertTrue(d in 1.1 - 1e-12..1.3 + 1e-12) { "$name: $d" }
                }
                assertEquals(energy, simulation.conserved().kineticEnergy, 1e-11 * energy)
                assertTrue(simulation.collisions!!.counters.let { it.edgeEvents > 5000 && it.collisions > 500 })
                stateDigest(simulation.population)
            }
        }
        assertEquals(1, digests.distinct().size) { "$digests" }
    }

    @Test
    fun `dimers touch where the least distance is contact, also in a box that is sheared, and in the plane`() {
        val sheared = setup(
            "bonds={\"length\":2,\"greatest\":1.05}",
            """boundary={"type":"lees-edwards","shearRate":0.5}""",
            "velocities.shearProfile=true",
            "restitution.coefficient=0.9",
        )
        val plane = setup(
            "dimensions=2",
            "bonds.length=3",
            "box.lengths=[20,20]",
            "particles.count=90",
            """interaction={"type":"square-well","ratio":1.5,"depth":0.5}""",
        )
        for ((setup, length, range) in listOf(Triple(sheared, 2, 1.0..1.05), Triple(plane, 3, 1.1..1.3))) {
            simulation(setup, "serial", 1).use { simulation ->
                repeat(50) {
                    simulation.advance()
                    for (d in lengths(simulation, length)) {
                        assertTrue(d in range.start - 1e-12..range.endInclusive + 1e-12) { "$length: $d" }
                    }
                }
            }
        }
    }

    @Test
    fun `chains that are none are refused`() {
        assertThrows(IllegalArgumentException::class.java) { Tether(0.9, 1.2) }
        assertThrows(IllegalArgumentException::class.java) { Tether(1.2, 1.2) }
        assertThrows(IllegalArgumentException::class.java) { Tether(1.0, Double.NaN) }
        assertThrows(IllegalArgumentException::class.java) { Chains(1, Tether(1.0, 1.2)) }
        val box = Box.centred(9.0, 9.0, 9.0)
        fun place(radii: DoubleArray, length: Int) = assertThrows(PlacementException::class.java) {
            ChainPlacement(length, 1.1, mostTries = 1000).place(radii, box, BooleanArray(3), SeededRandom(1))
        }.message!!
        assertTrue("whole number" in place(DoubleArray(5) { 0.5 }, 2))
        assertTrue("one radius" in place(doubleArrayOf(0.5, 0.4), 2))
        assertTrue("no room" in place(DoubleArray(400) { 0.5 }, 20))
    }
}
