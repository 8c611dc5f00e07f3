package daphnis.core.cluster

import daphnis.core.Engines
import daphnis.core.run.Run
import daphnis.core.run.Summary
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.atomic.AtomicInteger

@Timeout(120)
class NodesAgreeTest {
    @TempDir
    lateinit var home: Path

    /** Runs the built-in [name] for some steps serially and on nodes; the same state and tables. */
    private fun assertSame(name: String, nodes: Int, vararg settings: String) {
        val text = checkNotNull(Run::class.java.getResource("/daphnis/scenarios/$name.json")).readText()
        val all =
            settings.toList() + listOf("output.snapshotEvery=0", "output.checkpointEvery=9", "output.seriesEvery=4")
        val one = ScenarioJson.parse(text, name, all + "engine.name=serial")
        val expected = Run.start(one, name, home.resolve("serial"), engines = Engines).use { it.execute() }
        val fleet = FleetEngines(ThreadFleet(nodes) { 1 + it % 2 }, PATIENCE)
        val summary = Run.start(one, name, home.resolve("nodes"), engines = fleet).use { it.execute() }
        assertEquals(expected.stateDigest, summary.stateDigest, name)
        assertEquals(expected.collisions, summary.collisions)
        val rows = Files.readString(home.resolve("serial/series.csv"))
        assertEquals(rows, Files.readString(home.resolve("nodes/series.csv")))
        assertTrue(rows.lines().size > 5)
        val bodies = home.resolve("serial/bodies.csv")
        if (Files.exists(bodies)) {
            assertEquals(Files.readString(bodies), Files.readString(home.resolve("nodes/bodies.csv")))
        }
    }

    @Tag("thorough")
    @Test
    fun `moonlets and their gravity, which every node feels`() {
        val one = """{"radius": 40, "density": 200, "position": [0, 0, 0]}"""
        val other = """{"radius": 20, "density": 300, "position": [100, 150, 0]}"""
        assertSame("moonlet", 3, "untilOrbits=0.1", "particles.opticalDepth=0.03", "bodies=[$one, $other]", ROWS)
        assertTrue(Files.readAllLines(home.resolve("nodes/bodies.csv")).size > 10)
    }

    @Test
    fun `a ring patch in Hill's frame`() = assertSame("ring-patch", 3, "untilOrbits=0.2")

    @Test
    fun `a perturbed sheet, under whose images the cuts move`() =
        assertSame("perturbed-ring", 3, "untilOrbits=0.6", "boundary.perturbation=0.7")

    @Test
    fun `radial self-gravity, whose waves all nodes make together`() = assertSame(
        "ring-patch",
        3,
        "untilOrbits=0.2",
        // One node has the heaviest sphere, by which all of them round.
        """bodies=[{"radius":5,"density":900,"position":[9,0,0]}]""",
        """forces=[{"type":"self-gravity","method":"radial-modes","modes":20}]""",
    )

    @Test
    fun `thermostats, whose momentum and heat all nodes sum up together`() = assertSame(
        "cooling-gas",
        3,
        "until=3",
        """forces=[{"type":"white-noise","intensity":0.2,"conserveMomentum":true},
        {"type":"andersen","rate":0.3,"temperature":1},{"type":"rescaling","temperature":0.7,"time":2}]""",
        """timeStep={"type":"fixed","dt":0.1}""",
    )

    @Test
    fun `self-gravity, for which every node sees all spheres`() = assertSame(
        "self-gravity-wakes",
        3,
        "untilOrbits=0.02",
        """forces=[{"type":"self-gravity","method":"mesh","softening":0.1}]""",
    )

    @Test
    fun `spheres that grow until they press`() = assertSame("glass", 3, "until=3")

    @Tag("thorough")
    @Test
    fun `the wake of a satellite`() = assertSame("satellite-wake", 2, "untilOrbits=0.2")

    @Test
    fun `the flattened box of the paper`() = assertSame("paper-figure-1", 4, "until=2.5", "particles.count=20000")

    @Test
    fun `a gas that cools`() = assertSame("cooling-gas", 3, "until=3")

    @Test
    fun `a rough gas, whose spins start at none`() = assertSame("rough-gas", 3, "until=3")

    @Test
    fun `discs, whose temperature is that of two components`() = assertSame("hard-discs", 3, "output={}", "until=3")

    @Tag("thorough")
    @Test
    fun `a mixture, whose unlike spheres are rougher and stickier than like ones`() = assertSame(
        "mixture",
        3,
        "until=10",
        """contacts=[{"between": ["light", "heavy"], "restitution": {"type": "constant", "coefficient": 0.4},
            "roughness": {"type": "constant", "coefficient": 0.5}}]""",
    )

    @Tag("thorough")
    @Test
    fun `a dozen nodes in a row say little to each other, and the same comes out`() {
        val nodes = 12
        val text = checkNotNull(Run::class.java.getResource("/daphnis/scenarios/paper-figure-1.json")).readText()
        val settings = listOf("until=2.5", "particles.count=20000", "output.checkpointEvery=0")
        val one = ScenarioJson.parse(text, "paper", settings + "engine.name=serial")
        val expected = Run.start(one, "paper", home.resolve("serial"), engines = Engines).use { it.execute() }
        val fleet = ThreadFleet(nodes)
        val sent = AtomicInteger()
        fleet.onSend = { from, to, _ -> if (from != Mail.LEADER && to != Mail.LEADER) sent.incrementAndGet() }
        val engines = FleetEngines(fleet, PATIENCE)
        val summary = Run.start(one, "paper", home.resolve("nodes"), engines = engines).use { it.execute() }
        assertEquals(expected.stateDigest, summary.stateDigest)
        val perStep = sent.get().toDouble() / nodes / summary.steps
        // Five turns of four messages around, some for those near, and a few steps computed again or planned; from
        // each to all others there would be 55 and more.
        assertTrue(perStep in 20.0..40.0) { "$perStep" }
    }

    private fun scenario(settings: List<String>) = ScenarioJson.parse(SHEARED, "test", settings)

    private fun serial(settings: List<String>): Summary {
        val one = scenario(settings + "engine.name=serial")
        return Run.start(one, "test", home.resolve("serial"), engines = Engines).use { it.execute() }
    }

    @ParameterizedTest
    @ValueSource(ints = [1, 2, 3, 5])
    fun `nodes give the bits and the files of the serial engine`(nodes: Int) {
        val expected = serial(emptyList())
        val fleet = ThreadFleet(nodes) { 1 + it % 2 }
        val lines = ArrayList<String>()
        val run = Run.start(
            scenario(emptyList()),
            "test",
            home.resolve("nodes"),
            engines = FleetEngines(fleet, PATIENCE) {
                lines +=
                    it
            },
        )
        val summary = run.use { it.execute() }
        assertEquals(expected.stateDigest, summary.stateDigest)
        assertEquals(expected.collisions, summary.collisions)
        for (file in listOf("series.csv", "transport.csv", "collisions.csv")) {
            assertEquals(
                Files.readString(home.resolve("serial/$file")),
                Files.readString(home.resolve("nodes/$file")),
                file,
            )
        }
        assertEquals(1, lines.size)
        assertTrue(
            lines[0].startsWith("$nodes node${if (nodes == 1) "" else "s"} at the end: ") && " kB per step" in lines[0],
        ) {
            lines[0]
        }
        assertEquals(nodes == 1, ", 0 kB per step" in lines[0]) { lines[0] }
        assertEquals(1, fleet.crews)
    }

    private companion object {
        val PATIENCE: Duration = Duration.ofMillis(200)
        const val ROWS = "output.bodiesEvery=5"
        const val SHEARED = """{
            "name": "sheared", "until": 1.0,
            "box": {"lengths": [14, 14, 14]},
            "boundary": {"type": "lees-edwards", "shearRate": 0.7},
            "particles": {"count": 900, "sizes": {"type": "equal", "radius": 0.5}, "mass": 1.0},
            "placement": {"type": "random"},
            "velocities": {"type": "gaussian", "sigma": 1.0, "shearProfile": true},
            "restitution": {"type": "constant", "coefficient": 0.7},
            "timeStep": {"type": "fixed", "dt": 0.05},
            "output": {"seriesEvery": 1, "transportEvery": 2, "collisionLog": true, "checkpointEvery": 7}
        }"""
    }
}
