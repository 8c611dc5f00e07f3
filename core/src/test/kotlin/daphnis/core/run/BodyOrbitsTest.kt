package daphnis.core.run

import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.table.UnitsOfDimensions
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.hypot
import kotlin.math.sqrt

/** `bodies.csv`: orbits of bodies and what pushes them. */
class BodyOrbitsTest {
    @TempDir
    lateinit var home: Path

    /** Two moonlets among 150 particles; an oblate planet, Ω = 1. */
    private fun scenario(vararg settings: String): Scenario = ScenarioJson.parse(
        """
        {
          "name": "moonlets", "seed": 5,
          "frame": { "type": "hill", "angularSpeed": 1, "radialFactor": 0.95, "verticalFactor": 1.04 },
          "box": { "lengths": [40, 50, 6] }, "boundary": { "type": "hill-sheet" },
          "particles": { "count": 150, "sizes": { "type": "equal", "radius": 0.7 }, "mass": 1 },
          "bodies": [
            { "radius": 3, "mass": 60, "position": [-8, 5, 0] }, { "radius": 2, "mass": 30, "position": [9, -12, 0.5] },
          ],
          "velocities": { "type": "gaussian", "sigma": 0.5, "shearProfile": true },
          "restitution": { "type": "constant", "coefficient": 0.5 },
          "forces": [{ "type": "body-gravity", "constant": 0.3 }],
          "timeStep": { "type": "orbit-fraction", "steps": 200 }, "untilOrbits": 0.5,
          "output": { "seriesEvery": 0, "bodiesEvery": 10, "checkpointEvery": 7 }
        }
        """.trimIndent(),
        "moonlets",
        settings.toList(),
    )

    private fun run(name: String, vararg settings: String): Path = home.resolve(name).also { path ->
        Run.start(scenario(*settings), "moonlets", path).use { it.execute() }
    }

    /** The columns of the body number [which] in the run in [path]. */
    private fun rows(path: Path, which: Int = 0): Map<String, DoubleArray> {
        val lines = Files.readAllLines(path.resolve("bodies.csv")).map { it.split(',') }
        val names = lines[0].map { UnitsOfDimensions.nameIn(it) }
        val ids = lines.drop(1).map { it[names.indexOf("body")] }.distinct()
        val own = lines.drop(1).filter { it[names.indexOf("body")] == ids[which] }
        return names.withIndex().associate { (c, name) -> name to DoubleArray(own.size) { own[it][c].toDouble() } }
    }

    private fun rms(x: DoubleArray) = sqrt(x.sumOf { it * it } / x.size)

    @Test
    fun `without gravity impacts are all that pushes, to the square of the step`() {
        val path = run("impacts", "forces=[]", "untilOrbits=3")
        for (which in 0..1) {
            val rows = rows(path, which)
            assertEquals(61, rows.getValue("time").size)
            assertTrue(rows.getValue("impacts").sum() > 8) { "${rows.getValue("impacts").sum()}" }
            val rest = rms(rows.getValue("gravity_push")) / rms(rows.getValue("impact_push"))
            // Without the places of impacts in their steps it would be Ωh/√3, 0.018.
            assertTrue(rest < 3e-3) { "the rest is $rest of the push by impacts" }
            val x = rows.getValue("guiding_x")
            val pushed = rows.getValue("impact_push").sum() * 2 / (rows.getValue("mass")[0] * 0.95 * 0.95)
            assertEquals(pushed, x.last() - x[0], 3e-3 * rms(x))
        }
    }

    @Test
    fun `what gravity gives a moonlet it takes from the particle that passes`() {
        val path = run(
            "passage",
            "particles.count=1",
            "particles.mass=1e-9",
            "velocities={\"type\":\"rest\",\"shearProfile\":true}",
            """bodies=[{"radius":1,"mass":60,"position":[0,0,0]},{"radius":0.5,"mass":6,"position":[5,14,0]}]""",
            "box.lengths=[300,400,6]",
            "untilOrbits=0.8",
        )
        val moonlet = rows(path, 0)
        val particle = rows(path, 1)
        assertEquals(0.0, moonlet.getValue("impacts").sum() + moonlet.getValue("impact_push").sum())
        val given = moonlet.getValue("gravity_push").sum()
        assertTrue(abs(given) > 0.5) { "$given" }
        // The third sphere is far away and light: what remains is its pull.
        assertEquals(-given, particle.getValue("gravity_push").sum(), 0.03 * abs(given))
    }

    @Test
    fun `elements are those of the frame's frequencies, through the faces, and a free moonlet is pushed by nothing`() {
        val path = run(
            "free",
            "particles.count=1",
            "forces=[]",
            "untilOrbits=2",
            "output.bodiesEvery=25",
            "bodies=[{\"radius\":0.5,\"mass\":6,\"position\":[18,14,1],\"velocity\":[1.5,-26,0.2]}]",
        )
        val rows = rows(path)
        assertTrue(rows.getValue("x").let { it.max() - it.min() } > 38) { "it should go through a face" }
        val orbits = rows.getValue("time").map { it / (2 * PI) }
        for (k in orbits.indices) {
            for (name in listOf("e", "i", "guiding_x")) {
                assertEquals(rows.getValue(name)[0], rows.getValue(name)[k], 1e-10) { "$name in row $k" }
            }
            for ((name, factor) in listOf("phase" to 0.95, "vertical_phase" to 1.04)) {
                val turned = (rows.getValue(name)[k] - rows.getValue(name)[0]) / (2 * PI) - factor * orbits[k]
                assertEquals(0.0, turned - Math.rint(turned), 1e-10) { "$name in row $k" }
            }
        }
        assertEquals(0.0, rms(rows.getValue("gravity_push")), 1e-10)
        assertEquals(hypot(1.0, 0.2 / 1.04), rows.getValue("i")[0], 1e-12)
    }

    @Test
    fun `rows have the same bytes from every engine and after a resume, wherever it was broken off`() {
        val whole = Files.readAllBytes(run("serial", "engine.name=serial").resolve("bodies.csv"))
        for (engine in listOf("horizon", "islands", "thread-pool")) {
            val path = run(engine, "engine.name=$engine", "engine.threads=3")
            assertTrue(whole.contentEquals(Files.readAllBytes(path.resolve("bodies.csv")))) { engine }
        }
        for (steps in listOf(0L, 1L, 10L, 33L)) {
            val path = home.resolve("broken-$steps")
            Run.start(scenario(), "moonlets", path).use { run ->
                run.execute(cancelled = { run.simulation.step >= steps })
            }
            Run.resume(path).use { it.execute() }
            assertTrue(whole.contentEquals(Files.readAllBytes(path.resolve("bodies.csv")))) { "broken at $steps" }
        }
    }

    @Test
    fun `rows at intervals of time are those at the steps of these times, and none are written unless asked for`() {
        val steps = Files.readAllLines(run("steps").resolve("bodies.csv"))
        val times = run("times", "output.bodiesInterval=0.05", "output.intervalUnit=orbit")
        assertEquals(steps.size, Files.readAllLines(times.resolve("bodies.csv")).size)
        assertTrue(!Files.exists(run("none", "output.bodiesEvery=0").resolve("bodies.csv")))
        assertEquals(1, Files.readAllLines(run("nobody", "bodies=[]", "forces=[]").resolve("bodies.csv")).size)
    }
}
