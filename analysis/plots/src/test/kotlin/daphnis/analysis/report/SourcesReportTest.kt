package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.input.InputException
import daphnis.core.run.Run
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.abs

/** What reports say of runs in which spheres come and leave. */
class SourcesReportTest {
    @TempDir
    lateinit var home: Path

    private fun run(name: String, sources: String, vararg settings: String): Path {
        val path = home.resolve(name)
        val scenario = ScenarioJson.parse(GAS, "test", listOf("sources=[$sources]", *settings))
        Run.start(scenario, "test", path).use { it.execute() }
        return path
    }

    private fun report(path: Path): String {
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(from = 20.0)).write(path)
        return Files.readString(path.resolve("report.html"))
    }

    private fun numbers(path: Path) =
        Files.readAllLines(path.resolve("tables/numbers.csv")).map { it.split(',') }.associateBy { it[0] }

    @Test
    fun `a gas between reservoirs has its density on average, and each says what it brings`() {
        val path = run("gas", "$LEFT, $RIGHT")
        val page = report(path)
        assertTrue("Sources and sinks</h2>" in page)
        assertTrue("Sources: 0: reservoir; 1: reservoir." in page)
        // Ids are given again, and no density is that of the theory.
        assertTrue("spheres come or leave, so those that stay are no sample" in page)
        assertFalse("Relaxation</h2>" in page)
        val rows = numbers(path)
        fun value(key: String) = rows.getValue(key)[1].toDouble()
        fun error(key: String) = rows.getValue(key)[2].toDouble()
        assertTrue(rows.values.drop(1).all { it[4].isEmpty() }) { "a reference" }
        assertEquals(value("particles") * PI / 6 / 300, value("filling_factor"), 5 * error("filling_factor"))
        assertTrue(abs(value("filling_factor") - 0.1) < 5 * error("filling_factor"))
        assertTrue(abs(value("particle_fluctuations") - 0.4569) < 5 * error("particle_fluctuations"))
        for (k in 0..1) {
            assertTrue(abs(value("source${k}_rate")) < 5 * error("source${k}_rate"))
            assertTrue(error("source${k}_power") > 0)
            assertFalse("source${k}_energy" in rows)
            assertFalse("source${k}_refused" in rows)
        }
        // The table is of all times, and in the end all that came and left is what there is.
        val table = Files.readAllLines(path.resolve("tables/exchanged.csv")).map { it.split(',') }
        val last = table.last().map { it.toDouble() }
        assertEquals(table[1][1].toDouble() + last[2] - last[3] + last[4] - last[5], last[1])
        for (plot in listOf("particles", "exchanged")) {
            assertTrue(Files.exists(path.resolve("plots/$plot.svg"))) {
                plot
            }
        }
        assertEquals(
            rows.keys.count { it.startsWith("source") },
            Analysis(AnalysisInput.ofRun(path), AnalysisOptions(from = 20.0)).numbers().count { "source" in it.key },
        )
    }

    @Test
    fun `a stream and a sink say the energy of one sphere, and how much finds no place`() {
        val path = run("stream", "$SINK, $STREAM")
        val page = report(path)
        val rows = numbers(path)
        fun value(key: String) = rows.getValue(key)[1].toDouble()
        assertTrue(value("source0_rate") < 0 && value("source1_rate") > 0)
        assertTrue(value("source1_refused") in 0.05..0.9) { "${value("source1_refused")}" }
        assertEquals(10.0, value("source1_rate") / (1 - value("source1_refused")), 1.0)
        // ½ (2² + 3 · 0.5²)
        assertEquals(2.375, value("source1_energy"), 0.15)
        assertTrue(value("source0_energy") > 0)
        assertTrue("number of particles" in page || "N</td>" in page)
        // Of a number that has a trend, what is around its mean is not that of a gas.
        assertFalse("particle_fluctuations" in rows)
    }

    @Test
    fun `where spheres only leave, the number is judged, and those that stay diffuse`() {
        val page = report(run("sink", SINK, "output={\"seriesEvery\": 2, \"snapshotEvery\": 20}"))
        assertTrue("number of particles fell" in page) { page.substringAfter("<h2").take(3000) }
        assertFalse("those that come may have the ids" in page)
    }

    @Test
    fun `of a box that is empty at the end there is nothing to say`() {
        val path = run("empty", "{\"type\": \"outflow\"}")
        val e = assertThrows(InputException::class.java) { report(path) }
        assertTrue("has no particle left in its last state" in e.message!!) { e.message }
    }

    private companion object {
        const val LEFT = """{"type": "reservoir", "region": {"x": [-4, -1]}, "fillingFactor": 0.1, "temperature": 1}"""
        const val RIGHT = """{"type": "reservoir", "region": {"x": [1, 4]}, "fillingFactor": 0.1, "temperature": 1}"""
        const val SINK = """{"type": "outflow", "region": {"x": [1, 3], "y": [-1, 1], "z": [-1, 1]}}"""
        const val STREAM = """{"type": "inflow", "rate": 10, "region": {"x": [-4, -1]}, "velocity": [2, 0, 0],
            "sigma": 0.5}"""
        const val GAS = """{"name": "gas", "until": 150, "box": {"lengths": [12, 5, 5]},
            "boundary": {"type": "periodic"}, "placement": {"type": "random"},
            "particles": {"count": 50, "sizes": {"type": "equal", "radius": 0.5}, "mass": 1.0},
            "velocities": {"type": "gaussian", "sigma": 1.0},
            "restitution": {"type": "constant", "coefficient": 1}, "timeStep": {"type": "fixed", "dt": 0.1},
            "output": {"snapshotEvery": 15, "seriesEvery": 2, "transportEvery": 5}}"""
    }
}
