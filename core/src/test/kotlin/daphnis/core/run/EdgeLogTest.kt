package daphnis.core.run

import daphnis.core.scenario.ScenarioJson
import daphnis.core.table.UnitsOfDimensions
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** `collisions.csv` of spheres with interactions: what is a contact, what an edge, and what each took. */
class EdgeLogTest {
    @TempDir
    lateinit var home: Path

    private fun rows(file: String): List<Map<String, Double>> {
        val lines = Files.readAllLines(home.resolve("run/$file")).map { it.split(',') }
        val head = lines.first().map(UnitsOfDimensions::nameIn)
        return lines.drop(1).map { row -> head.zip(row.map { it.toDouble() }).toMap() }
    }

    @Test
    fun `rows say which are of edges, and their losses are what the gas has lost`() {
        val scenario = ScenarioJson.parse(WET, "test", emptyList())
        val summary = Run.start(scenario, "test", home.resolve("run")).use { it.execute() }
        val all = rows("collisions.csv")
        val edges = all.filter { it.getValue("edge") != 0.0 }
        assertEquals(summary.edgeEvents, edges.size.toLong())
        assertEquals(summary.collisions, (all.size - edges.size).toLong())
        // Bridges break outward or turn the two back.
        assertEquals(setOf(2.0, 3.0), edges.map { it.getValue("edge") }.toSet())
        for (row in edges) {
            assertTrue(listOf("x", "y", "z").sumOf { row.getValue("separation_$it").let { d -> d * d } } > 1.2)
        }
        val lost = all.sumOf { row ->
            val restitution =
                0.5 * row.getValue("impulse") * (1 - row.getValue("coefficient")) * row.getValue("impact_speed")
            row.getValue("surface_dissipation") + if (row.getValue("edge") == 0.0) restitution else 0.0
        }
        val before = rows("series.csv").first().getValue("kinetic_energy")
        assertTrue(lost > 0.1 * before) { "$lost of $before" }
        assertEquals(before - summary.energy, lost, 1e-11 * before)
    }

    @Test
    fun `rows of spheres that merge and break have all that was lost`() {
        val changes = listOf(
            "interaction=null",
            "merging={\"type\": \"slow\", \"speed\": 0.5}",
            "breaking={\"speed\": 1.5, \"pieces\": 3, \"spread\": 0.2, \"smallest\": 0.1}",
        )
        val scenario = ScenarioJson.parse(WET, "test", changes)
        val summary = Run.start(scenario, "test", home.resolve("run")).use { it.execute() }
        val all = rows("collisions.csv")
        assertTrue("edge" !in all.first())
        val lost = all.sumOf { row ->
            row.getValue("surface_dissipation") +
                0.5 * row.getValue("impulse") * (1 - row.getValue("coefficient")) * row.getValue("impact_speed")
        }
        val before = rows("series.csv").first().getValue("kinetic_energy")
        assertTrue(summary.broken > 20 && summary.mergers > 20) { "${summary.broken} ${summary.mergers}" }
        assertEquals(before - summary.energy, lost, 1e-11 * before)
    }

    private companion object {
        const val WET = """{"name": "wet", "until": 3, "box": {"lengths": [7, 7, 7]}, "boundary": {"type": "periodic"},
            "particles": {"count": 100, "sizes": {"type": "equal", "radius": 0.5}, "mass": 1.0},
            "placement": {"type": "random"}, "velocities": {"type": "gaussian", "sigma": 1.0},
            "interaction": {"type": "bridge", "ratio": 1.2, "energy": 0.1},
            "restitution": {"type": "constant", "coefficient": 0.9}, "timeStep": {"type": "fixed", "dt": 0.05},
            "output": {"collisionLog": true}}"""
    }
}
