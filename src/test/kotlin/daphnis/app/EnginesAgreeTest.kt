package daphnis.app

import daphnis.core.Repository.read
import daphnis.core.Simulation
import daphnis.core.engine.EnginesAgreeContract
import daphnis.core.engine.TestedEngines
import daphnis.core.population.stateDigest
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.wall.Piston
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs

/** Every engine that the command line knows, as it is registered. Their modules draw cases by the hundred. */
class EnginesAgreeTest : EnginesAgreeContract(TestedEngines(allEngines), draws = 6) {
    @Test
    fun `the docs name the engines of the registry`() {
        val table = read("docs/concurrency.md").lines().dropWhile { !it.startsWith("| engine ") }
            .takeWhile { it.startsWith("|") }
        val named = table.drop(2).map { it.split('|')[1].trim().trim('`') }
        assertEquals(allEngines.names.toSet() - "serial", named.toSet()) { "table of docs/concurrency.md" }
        for (page in listOf("README.md", "docs/reference/scenario-keys.md", "docs/reference/commands.md")) {
            val missing = allEngines.names.filter { Regex("\\b$it\\b") !in read(page) }
            assertTrue(missing.isEmpty()) { "$page does not name $missing" }
        }
    }

    @Test
    fun `pistons move alike with every engine`() {
        val text = """{
            "box": { "lengths": [9, 9, 9] },
            "boundary": { "type": "walls", "axes": "x", "faces": {
              "lowerX": { "motion": { "type": "piston", "mass": 60, "force": 9, "velocity": 0.1 } },
              "upperX": { "motion": { "type": "piston", "mass": 45, "force": -8, "position": 0.5 } } } },
            "particles": { "count": 500, "sizes": { "type": "equal", "radius": 0.3 }, "mass": 1 },
            "velocities": { "type": "gaussian", "sigma": 1 },
            "restitution": { "type": "constant", "coefficient": 0.9 },
            "timeStep": { "type": "fixed", "dt": 0.05 }, "until": 5
        }"""
        fun bits(name: String): List<Any> {
            val setup = ScenarioSetup.of(ScenarioJson.parse(text, "test", emptyList()), "test")
            val forcing = setup.collisions(allEngines.create(name, 2)!!)
            Simulation(setup.population, setup.boundary, forcing, setup.timeStep).use { simulation ->
                repeat(60) { simulation.advance() }
                val pistons = listOf(0, 1).map { setup.boundary.walls[it]!!.motion as Piston }
                // In a time of 3 the forces alone would give them these speeds.
                for ((piston, forced) in pistons.zip(listOf(0.1 + 9.0 / 60 * 3, -8.0 / 45 * 3))) {
                    assertTrue(abs(piston.speed - forced) > 0.01) { "nothing hit it: ${piston.speed}" }
                }
                return listOf(stateDigest(simulation.population)) + pistons.flatMap { listOf(it.position, it.speed) }
            }
        }
        val expected = bits("serial")
        for (name in allEngines.names) assertEquals(expected, bits(name)) { name }
    }
}
