package daphnis.core.cluster

import daphnis.core.Engines
import daphnis.core.run.Run
import daphnis.core.run.RunException
import daphnis.core.run.Summary
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.Random
import java.util.concurrent.atomic.AtomicInteger

/** Nodes die and come in runs; the end has the bits of the serial engine, and the files are the same. */
@Timeout(120)
class NodeLossTest {
    @TempDir
    lateinit var home: Path
    private lateinit var expected: Summary
    private val lines = ArrayList<String>()

    private fun scenario(vararg settings: String) = ScenarioJson.parse(GAS, "test", settings.toList())

    private fun start(fleet: Fleet, name: String = "nodes", vararg settings: String) = Run.start(
        scenario(*settings),
        "test",
        home.resolve(name),
        engines = FleetEngines(fleet, PATIENCE) {
            lines += it
        },
    )

    @BeforeEach
    fun serial() {
        expected = Run.start(scenario("engine.name=serial"), "test", home.resolve("serial"), engines = Engines)
            .use { it.execute() }
    }

    private fun assertSame(name: String, summary: Summary) {
        assertEquals(expected.stateDigest, summary.stateDigest)
        assertEquals(expected.collisions, summary.collisions)
        assertEquals(expected.wallCollisions, summary.wallCollisions)
        for (file in listOf("series.csv", "collisions.csv")) {
            assertEquals(Files.readString(home.resolve("serial/$file")), Files.readString(home.resolve("$name/$file")))
        }
    }

    @Tag("thorough")
    @Test
    fun `a node that dies at any message changes no bit and no line`() {
        val random = Random(5)
        var lost = 0
        repeat(25) { turn ->
            val fleet = ThreadFleet(4) { 1 + it % 2 }
            val left = AtomicInteger(1 + random.nextInt(1500))
            val victim = random.nextInt(4)
            fleet.onSend = { _, _, _ -> if (left.decrementAndGet() == 0) fleet.kill(victim) }
            val summary = start(fleet, "nodes$turn").use { it.execute() }
            assertSame("nodes$turn", summary)
            if (left.get() <= 0) {
                lost++
                assertEquals(2, fleet.crews)
                assertEquals(3, fleet.nodes().size)
            }
        }
        assertTrue(lost > 10) { "only $lost were lost" }
        assertTrue(lines.any { "is lost; 3 nodes continue from step" in it }) { "$lines" }
    }

    @Test
    fun `nodes die one after the other, down to the last one`() {
        val fleet = ThreadFleet(4)
        val sent = AtomicInteger()
        fleet.onSend = { _, _, _ -> if (sent.incrementAndGet() in setOf(300, 340, 700)) fleet.kill(0) }
        assertSame("nodes", start(fleet).use { it.execute() })
        assertEquals(1, fleet.nodes().size)
        assertEquals(4, fleet.crews)
        assertTrue("is lost; 1 node continues from step" in lines[lines.size - 2]) { "$lines" }
    }

    @Test
    fun `when the last node is lost the run ends with a line, and resume goes on from its checkpoint`() {
        val fleet = ThreadFleet(2)
        val sent = AtomicInteger()
        fleet.onSend = { _, _, _ ->
            if (sent.incrementAndGet() == 200) {
                fleet.kill(0, 1)
            }
        }
        val e = start(fleet).use { assertThrows(RunException::class.java) { it.execute() } }
        assertTrue("no node has come" in e.message.orEmpty()) { e.message.orEmpty() }
        val resumed = Run.resume(
            home.resolve("nodes"),
            engines = FleetEngines(ThreadFleet(3), PATIENCE) {
                lines += it
            },
        )
        resumed.use {
            assertTrue(it.resumedFrom > 0)
            assertSame("nodes", it.execute())
        }
    }

    @Test
    fun `a node that comes takes its share, and changes no bit`() {
        val fleet = ThreadFleet(1)
        val sent = AtomicInteger()
        fleet.onSend = { _, _, _ -> if (sent.incrementAndGet() in setOf(20, 90)) fleet.add(2) }
        assertSame("nodes", start(fleet).use { it.execute() })
        assertEquals(3, fleet.crews)
    }

    @Test
    fun `a run saved on four nodes goes on with three, one, none and two`() {
        for ((step, nodes) in listOf(4, 3, 1, 0, 2).withIndex()) {
            val engines = if (nodes == 0) Engines else FleetEngines(ThreadFleet(nodes), PATIENCE) { lines += it }
            val path = home.resolve("nodes")
            val run = if (step ==
                0
            ) {
                Run.start(scenario(), "test", path, engines = engines)
            } else {
                Run.resume(path, engines = engines)
            }
            run.use { r ->
                val last = if (step == 4) Long.MAX_VALUE else 4L * (step + 1)
                val summary = r.execute(cancelled = { r.simulation.step >= last })
                assertEquals(step == 4, summary.finished)
                if (summary.finished) assertSame("nodes", summary)
            }
        }
    }

    @Test
    fun `rows, log and copies only now and then give the same`() {
        val fleet = ThreadFleet(3)
        val summary = start(fleet, "nodes", "output.seriesEvery=0", "output.collisionLog=false").use { it.execute() }
        assertEquals(expected.stateDigest, summary.stateDigest)
        assertEquals(expected.collisions, summary.collisions)
        assertEquals(listOf("cluster", "3"), listOf(summary.engine, "${summary.threads}"))
    }

    @Test
    fun `a step that fails on nodes fails as on one machine, and the state before it is kept`() {
        val falling = arrayOf("until=5", FIXED, "boundary={\"type\": \"periodic\"}", FALL, "output.collisionLog=false")
        val path = home.resolve("one")
        val one = Run.start(scenario(*falling, "engine.name=serial"), "test", path, engines = Engines)
        val expected = one.use { assertThrows(RunException::class.java) { it.execute() } }.message
        assertTrue("images" in expected.orEmpty()) { expected.orEmpty() }
        val e = start(ThreadFleet(3), "nodes", *falling).use { assertThrows(RunException::class.java) { it.execute() } }
        assertEquals(expected, e.message)
        for (engines in listOf(Engines, FleetEngines(ThreadFleet(2), PATIENCE))) {
            val resumed = Run.resume(home.resolve("nodes"), engines = engines)
            resumed.use {
                val failed = assertThrows(RunException::class.java) { it.execute() }
                assertEquals("step ${it.resumedFrom + 1}: ", failed.message!!.substringBefore(": ") + ": ")
                assertEquals(expected, failed.message)
            }
        }
        val series = "series.csv"
        assertEquals(Files.readString(path.resolve(series)), Files.readString(home.resolve("nodes/$series")))
    }

    private companion object {
        const val FIXED = "timeStep={\"type\": \"fixed\", \"dt\": 0.05}"
        const val FALL = "forces=[{\"type\": \"uniform-acceleration\", \"acceleration\": [4000, 0, 0]}]"

        val PATIENCE: Duration = Duration.ofMillis(200)
        const val GAS = """{
            "name": "gas", "until": 1.0,
            "box": {"lengths": [14, 9, 9]},
            "boundary": {"type": "walls"},
            "particles": {"count": 500, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
            "placement": {"type": "random"},
            "velocities": {"type": "gaussian", "sigma": 2.0},
            "restitution": {"type": "constant", "coefficient": 0.8},
            "timeStep": {"type": "cell-crossing", "fraction": 0.2, "longest": 0.1},
            "output": {"seriesEvery": 3, "collisionLog": true, "checkpointEvery": 5}
        }"""
    }
}
