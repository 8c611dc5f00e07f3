package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** The report of a vibrated bed. */
class DrivenWallsReportTest {
    @Test
    fun `a bed has no pressure of its box, but work of its floor and temperature over height`(@TempDir home: Path) {
        val settings =
            listOf("particles.count=100", "box.lengths=[5,5,60]", "until=40", "output.transportEvery=13")
        Run.start(BuiltIn.scenario("vibrated-bed", settings), "vibrated-bed", home).use { it.execute() }
        Analysis(AnalysisInput.ofRun(home)).write(home)
        val keys = Files.readAllLines(home.resolve("tables/numbers.csv")).map { it.substringBefore(',') }
        assertTrue("compressibility" !in keys && "filling_factor" !in keys && "collisions_per_particle" in keys)
        val work = Files.readAllLines(home.resolve("tables/numbers.csv")).map { it.split(',') }
            .first { it[0] == "wall_work_over_dissipation" }[1].toDouble()
        assertEquals(1.0, work, 0.5)
        assertTrue(Files.exists(home.resolve("plots/vertical-temperature.svg")))
        val html = Files.readString(home.resolve("report.html"))
        assertTrue("cycles of a wall" !in html)
        assertTrue(">The box</h2>" in html && "patch" !in html.replace(Regex("base64,[^\"]*"), "")) {
            "a bed is no ring"
        }
        assertTrue("Occultation" !in html && "ptical depth" !in html && "⟨c_z²⟩ is no temperature" in html)
        // 13 states from time 15 on.
        assertTrue("A run with --until 160 may be long enough for these errors." in html) {
            html.substringAfter("<sup>?</sup>").take(500)
        }
    }

    @Test
    fun `a run that was interrupted is called so, and its scenario is not said to give its digest`(
        @TempDir home: Path,
    ) {
        var steps = 0
        Run.start(BuiltIn.scenario("vibrated-bed", listOf("particles.count=50")), "bed", home).use {
            assertFalse(it.execute(cancelled = { ++steps > 100 }).finished)
        }
        Analysis(AnalysisInput.ofRun(home)).write(home)
        val html = Files.readString(home.resolve("report.html"))
        assertTrue("interrupted before the end of the scenario" in html && "did not reach the end" in html)
        assertTrue("the same state digest" !in html)
    }

    @Test
    fun `outputs in step with a wall are named`() {
        fun said(vararg settings: String) = DrivenWalls.inStep(BuiltIn.scenario("vibrated-bed", settings.toList()))
        assertEquals(emptyList<String>(), said())
        val lines = said("output.transportEvery=20", "output.snapshotEvery=200")
        assertEquals(2, lines.size)
        assertTrue(
            lines[0].startsWith("output.snapshotEvery is 10") && lines[1].startsWith("output.transportEvery is 1"),
        )
        assertEquals(1, said("output.transportInterval=3.0005").size)
        assertTrue(said("output.seriesEvery=40").single().startsWith("output.seriesEvery is 2 cycles"))
        assertEquals(emptyList<String>(), said("output.transportInterval=3.002"))
    }

    @Test
    fun `the volume under a piston is that between the walls`(@TempDir home: Path) {
        val piston = """{ "type": "piston", "mass": 20, "force": -5, "position": 1 }"""
        val scenario = ScenarioJson.parse(
            """{
              "box": { "lengths": [10, 5, 5] },
              "boundary": { "type": "walls", "axes": "x", "faces": { "upperX": { "motion": $piston } } },
              "particles": { "count": 60, "sizes": { "type": "equal", "radius": 0.1 }, "mass": 1 },
              "velocities": { "type": "gaussian", "sigma": 1, "exact": true },
              "restitution": { "type": "constant", "coefficient": 1 },
              "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 1500,
              "output": { "seriesEvery": 5, "transportEvery": 5 }
            }""",
            "test",
        )
        Run.start(scenario, "test", home).use { it.execute() }
        Analysis(AnalysisInput.ofRun(home)).write(home)
        val numbers = Files.readAllLines(home.resolve("tables/numbers.csv")).map { it.split(',') }.associateBy { it[0] }
        assertTrue("filling_factor" !in numbers && "compressibility" !in numbers) { "${numbers.keys}" }
        val volume = numbers.getValue("volume")
        // F L = N kT and some more for the radii.
        val expected = 60 * numbers.getValue("granular_temperature")[1].toDouble() / 5 * 25 + 2 * 0.1 * 25
        assertEquals(1.0, volume[1].toDouble() / expected, 0.06) { "$volume of $expected" }
    }
}
