package daphnis.core.scenario

import daphnis.core.input.InputException
import daphnis.core.run.RecordedRun
import daphnis.core.run.Run
import daphnis.core.run.RunDirectory
import daphnis.core.run.RunOrigin
import daphnis.core.run.Summary
import daphnis.core.run.toStep
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** Pistons in scenarios: keys, series, checkpoints. */
class PistonScenarioTest {
    @TempDir
    lateinit var home: Path

    private fun scenario(motion: String, vararg settings: String, more: String = "") = ScenarioJson.parse(
        """{
          "box": { "lengths": [10, 5, 5] },
          "boundary": { "type": "walls", "axes": "x", "faces": { "upperX": { "motion": { $motion } $more } } },
          "particles": { "count": 80, "sizes": { "type": "equal", "radius": 0.2 }, "mass": 2 },
          "velocities": { "type": "gaussian", "sigma": 1 },
          "restitution": { "type": "constant", "coefficient": 1 },
          "timeStep": { "type": "fixed", "dt": 0.05 }, "until": 4, "output": { "checkpointEvery": 7 }
        }""",
        "test",
        settings.toList(),
    )

    private val plain = """"type": "piston", "mass": 40, "force": -9"""

    private fun refused(motion: String, vararg settings: String, more: String = ""): String =
        assertThrows(InputException::class.java) {
            ScenarioSetup.of(scenario(motion, *settings, more = more), "test")
        }.message.orEmpty()

    private fun results(directory: Path) = listOf(
        Files.readAllLines(directory.resolve("series.csv")),
        Summary.read(RunDirectory(directory).summary).stateDigest,
    )

    @Test
    fun `a run that is resumed goes on with the same bits, and its series has the piston`() {
        val whole = home.resolve("whole")
        Run.start(scenario(plain), "test", whole).use { it.execute() }
        val rows = Files.readAllLines(whole.resolve("series.csv")).map { row ->
            row.split(',').map { it.substringBefore(" [") }
        }
        assertEquals(
            listOf("piston_position_upper_x", "piston_speed_upper_x", "piston_energy"),
            rows[0].filter { it.startsWith("piston") },
        )
        fun column(name: String) = rows[0].indexOf(name).let { k -> rows.drop(1).map { it[k].toDouble() } }
        assertEquals(0.0, column("piston_position_upper_x").first())
        assertTrue(column("piston_position_upper_x").last() > 0.05)
        val energies = column("total_energy").zip(column("piston_energy")) { a, b -> a + b }
        assertTrue(energies.all { kotlin.math.abs(it / energies[0] - 1) < 0.01 }) { "$energies" }
        for (step in listOf(7L, 31L)) {
            val directory = home.resolve("part-$step")
            Run.start(scenario(plain), "test", directory).toStep(step)
            Run.resume(directory).use { it.execute() }
            assertEquals(results(whole), results(directory)) { "from step $step" }
        }
    }

    @Test
    fun `a start from a state has the piston where it was, inward or outward, to the bits of the uninterrupted run`() {
        val key = "boundary.faces.upperX.motion"
        for ((name, motion) in listOf("out" to plain, "in" to plain.replace("-9", "-40"))) {
            val whole = home.resolve(name)
            Run.start(scenario(motion, "output.snapshotEvery=7"), "test", whole).use { it.execute() }
            val run = Run.open(whole)
            fun digest(n: String, origin: RunOrigin, vararg settings: String): String = Run.start(
                scenario(motion, "output.snapshotEvery=7", *settings),
                "test",
                home.resolve("$name-$n"),
                from = origin,
            )
                .use { it.execute().stateDigest }
            for (step in run.steps().dropLast(1)) {
                assertEquals(run.summary()!!.stateDigest, digest("$step", RunOrigin(run, run.atStep(step)))) { "$step" }
            }
            val written = Run.open(home.resolve("$name-7"))
            val state = written.atStep(written.steps()[1])
            assertEquals(run.summary()!!.stateDigest, digest("again", RunOrigin(written, state)))
        }
    }

    @Test
    fun `a state of which nothing says where the piston was is refused, and one that was none begins as it is said`() {
        fun run(name: String, motion: String) = home.resolve(name).let { directory ->
            val settings = arrayOf("output.snapshotEvery=7", "output.seriesEvery=5")
            Run.start(scenario(motion, *settings), "test", directory).use { it.execute() }
            Run.open(directory)
        }
        fun start(n: Int, run: RecordedRun, motion: String = plain) =
            Run.start(scenario(motion), "test", home.resolve("$n"), from = RunOrigin(run, run.atStep(7)))
        val run = run("whole", plain)
        val told = assertThrows(InputException::class.java) { start(1, run) }.message.orEmpty()
        assertTrue("boundary.faces.upperX.motion: is a piston, and nothing says where it was" in told) { told }
        // A row that is torn in the speed, as by a full disk.
        val torn = home.resolve("torn")
        Run.start(scenario(plain, "output.snapshotEvery=8"), "test", torn).use { it.execute() }
        val series = torn.resolve("series.csv")
        val text = Files.readString(series)
        val rows = text.substring(0, text.indexOf('\n', text.indexOf("\n8,") + 1))
        Files.writeString(series, rows.substringBeforeLast(',').dropLast(3))
        val ofTorn = Run.open(torn)
        assertThrows(InputException::class.java) {
            Run.start(scenario(plain), "test", home.resolve("4"), from = RunOrigin(ofTorn, ofTorn.atStep(8)))
        }
        Files.write(series, byteArrayOf(0x80.toByte(), 0x0a))
        val bytes = assertThrows(InputException::class.java) {
            Run.start(scenario(plain), "test", home.resolve("4"), from = RunOrigin(ofTorn, ofTorn.atStep(8)))
        }
        assertTrue("series.csv: has 2 bytes where the run wrote" in bytes.message.orEmpty()) { "${bytes.message}" }
        // Rows that are of another run, or twice.
        val row = text.lines().first { it.startsWith("8,") }
        val time = row.split(',')[1]
        for (wrong in listOf(text.replace("8,$time,", "8,0.5,"), text.replace(row, "$row\n$row"))) {
            Files.writeString(series, wrong)
            assertThrows(InputException::class.java) {
                Run.start(scenario(plain), "test", home.resolve("5"), from = RunOrigin(ofTorn, ofTorn.atStep(8)))
            }
        }
        Files.writeString(series, text)
        val moved = scenario("""$plain, "position": 0.7""")
        Run.start(moved, "test", home.resolve("6"), from = RunOrigin(ofTorn, ofTorn.atStep(8))).use {
            val told = it.notices.single { notice -> "the piston goes on from where it is" in notice }
            assertTrue("boundary.faces.upperX.motion" in told) { told }
        }
        start(2, run, """"type": "steady", "velocity": 0.1""").close()
        start(3, run("steady", """"type": "steady", "velocity": 0"""), """$plain, "position": 0.5""").close()
        val written = ScenarioJson.read(home.resolve("3/scenario.json")).boundary
        assertEquals(0.5, written.pistons.getValue(1)[0])
    }

    @Test
    fun `a run without a piston has none in its series`() {
        val directory = home.resolve("steady")
        Run.start(scenario(""""type": "steady", "velocity": 0.1"""), "test", directory).use { it.execute() }
        assertTrue("piston" !in Files.readAllLines(directory.resolve("series.csv"))[0])
    }

    @Test
    fun `what is wrong is refused in a line with its key`() {
        val key = "boundary.faces.upperX"
        fun piston(rest: String) = """"type": "piston", $rest"""
        val cases = listOf(
            refused(piston(""""mass": 0""")) to "$key.motion.mass: is 0.0; must be > 0",
            refused(piston(""""mass": 19""")) to
                "$key.motion.mass: is 19.0; must be 10.0 times the mass of the heaviest",
            refused(plain, more = """, "temperature": 2""") to "$key.temperature: is of a piston",
            refused(plain, """boundary.roughness={"all":{"type":"constant","coefficient":0.5}}""") to
                "$key: is a piston, which",
            refused(piston(""""mass": 40, "position": -9.7""")) to "does not fit between the walls along x",
        )
        for ((told, words) in cases) {
            assertTrue(words in told && '\n' !in told) { "$words: $told" }
        }
        assertTrue("piston of mass 40.0 under the force -9.0" in scenario(plain).boundary.inWords({ "$it" }, { "$it" }))
    }

    @Test
    fun `a force that is strong for the step is told`() {
        fun warned(force: Int) =
            warnings(ScenarioSetup.of(scenario(""""type": "piston", "mass": 40, "force": $force"""), "t"))
        assertEquals(emptyList<String>(), warned(-9))
        assertTrue("the force on the piston upperX changes its speed by 0.1" in warned(-100).single()) {
            "${warned(-100)}"
        }
    }
}
