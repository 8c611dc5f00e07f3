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
import java.nio.ByteBuffer
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.Random

/** What goes wrong while nodes take the sums of a row. */
@Timeout(120)
class NodeSumsLossTest {
    @TempDir
    lateinit var home: Path
    private lateinit var expected: Summary
    private val lines = ArrayList<String>()

    private fun scenario(vararg settings: String) = ScenarioJson.parse(
        RowCase.WALLS.text,
        "test",
        listOf("output.seriesEvery=1", "output.transportEvery=1", "output.collisionLog=true") + settings,
    )

    private fun start(fleet: Fleet, name: String = "nodes") = Run.start(
        scenario(),
        "test",
        home.resolve(name),
        engines = FleetEngines(fleet, Duration.ofMillis(200), { lines += it }, CopyClock { 0 }),
    )

    @BeforeEach
    fun serial() {
        expected = Run.start(scenario("engine.name=serial"), "test", home.resolve("serial"), engines = Engines)
            .use { it.execute() }
    }

    private fun assertSame(name: String, summary: Summary) {
        assertEquals(expected.stateDigest, summary.stateDigest)
        for (file in listOf("series.csv", "transport.csv", "collisions.csv")) {
            assertEquals(Files.readString(home.resolve("serial/$file")), Files.readString(home.resolve("$name/$file")))
        }
    }

    /** Calls [act] before the messages of rounds of sums: questions and answers, counted from 1. */
    private fun ThreadFleet.onSums(act: (count: Int, from: Int, message: ByteBuffer) -> Unit) {
        var command = Command.STEP
        var count = 0
        onSend = { from, to, message ->
            synchronized(lines) {
                if (from == Mail.LEADER && message.remaining() == 1 + 8 * Double.SIZE_BYTES + Int.SIZE_BYTES) {
                    command = Command.CENTRAL_SUMS
                } else if (from == Mail.LEADER && message.remaining() == 1) {
                    command = Command.entries[message.get(message.position()).toInt()]
                }
                val isSums = command == Command.FIRST_SUMS || command == Command.CENTRAL_SUMS
                if (isSums && (from == Mail.LEADER || to == Mail.LEADER)) act(++count, from, message)
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `a node that dies at any message of a round changes no bit and no line`() {
        val random = Random(11)
        // Ten steps with two rounds of eight messages each.
        for ((turn, at) in ((1..16) + List(12) { 17 + random.nextInt(140) }).withIndex()) {
            val fleet = ThreadFleet(4) { 1 + it % 2 }
            val victim = random.nextInt(4)
            fleet.onSums { count, _, _ -> if (count == at) fleet.kill(victim) }
            val summary = start(fleet, "nodes$turn").use { it.execute() }
            assertSame("nodes$turn", summary)
            assertEquals(listOf(2, 3), listOf(fleet.crews, fleet.nodes().size)) { "killed at message $at" }
            assertTrue("is lost; 3 nodes continue from step 0" in lines[lines.size - 2]) { "$lines" }
        }
    }

    @Test
    fun `nodes die in the rounds of one row, down to the last one`() {
        val fleet = ThreadFleet(4)
        fleet.onSums { count, _, _ -> if (count in setOf(13, 20, 25)) fleet.kill(0) }
        assertSame("nodes", start(fleet).use { it.execute() })
        assertEquals(1, fleet.nodes().size)
        assertEquals(4, fleet.crews)
    }

    @Test
    fun `when the last node is lost in a round the run ends with a line, and resume goes on to the same rows`() {
        val fleet = ThreadFleet(2)
        fleet.onSums { count, _, _ ->
            if (count == 30) {
                fleet.kill(0, 1)
            }
        }
        val e = start(fleet).use { assertThrows(RunException::class.java) { it.execute() } }
        assertTrue(Regex("step \\d+: no node has come within 0 s").matches(e.message.orEmpty())) { e.message.orEmpty() }
        Run.resume(home.resolve("nodes"), engines = FleetEngines(ThreadFleet(3))).use {
            assertSame("nodes", it.execute())
        }
    }

    @Test
    fun `an answer that is damaged ends the run with a line that names the node`() {
        val damages = listOf<(ByteBuffer) -> Unit>(
            { it.limit(it.limit() - 1) },
            { it.limit(0) },
            { it.putInt(0, -1) },
        )
        for ((k, damage) in damages.withIndex()) {
            val fleet = ThreadFleet(3)
            fleet.onSums { count, from, message -> if (from == 1 && count > 20) damage(message) }
            val e = start(fleet, "nodes$k").use { assertThrows(RunException::class.java) { it.execute() } }
            val line = Regex("step \\d+: node node 2: its answer is damaged: .+")
            assertTrue(line.matches(e.message.orEmpty())) { "$k: ${e.message}" }
        }
    }

    @Test
    fun `a leader that is interrupted in a round asks again with the same bits as answer`() {
        val fleet = ThreadFleet(3)
        var interruptAt = 0
        fleet.onSums { count, from, _ ->
            if (count == interruptAt && from == Mail.LEADER) Thread.currentThread().interrupt()
        }
        start(fleet).use { run ->
            val simulation = run.simulation
            repeat(2) { simulation.advance() }
            val before = simulation.conserved()
            interruptAt = 7
            assertThrows(IllegalStateException::class.java) { simulation.conserved() }
            assertTrue(Thread.interrupted())
            val after = simulation.conserved()
            assertEquals(before.kineticEnergy, after.kineticEnergy)
            assertEquals(before.momentumX, after.momentumX)
            assertEquals(2, fleet.crews)
            simulation.advance()
            assertEquals(3L, simulation.step)
            assertEquals(200, simulation.population.size)
        }
    }
}
