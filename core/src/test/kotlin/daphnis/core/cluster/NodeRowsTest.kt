package daphnis.core.cluster

import daphnis.core.CarriedState
import daphnis.core.Engines
import daphnis.core.Output
import daphnis.core.population.Conserved
import daphnis.core.population.stateDigest
import daphnis.core.run.Run
import daphnis.core.run.RunException
import daphnis.core.run.Summary
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.Random
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicInteger

/** Rows of tables of runs on nodes: the characters of the serial engine's, and the spheres stay where they are. */
@Timeout(120)
class NodeRowsTest {
    @TempDir
    lateinit var home: Path

    private fun scenario(case: RowCase, settings: Array<out String>) =
        ScenarioJson.parse(case.text, "test", EVERY_ROW + settings)

    private fun serial(case: RowCase, vararg settings: String): Summary {
        val one = scenario(case, arrayOf(*settings, "engine.name=serial"))
        return Run.start(one, "test", home.resolve("serial"), force = true, engines = Engines).use { it.execute() }
    }

    private fun nodes(fleet: Fleet, case: RowCase, watcher: Output, vararg settings: String): Summary {
        // No copies for safety.
        val engines = FleetEngines(fleet, Duration.ZERO, { }, CopyClock { 0 })
        val run = Run.start(scenario(case, settings), "test", home.resolve("nodes"), force = true, engines = engines)
        return run.use { it.execute(watcher) }
    }

    private fun rows(run: String, file: String) = Files.readAllLines(home.resolve("$run/$file"))

    private fun assertSameRows() {
        for (file in listOf(
            "series.csv",
            "transport.csv",
        )) {
            assertEquals(rows("serial", file), rows("nodes", file), file)
        }
    }

    @ParameterizedTest
    @EnumSource
    fun `rows have the characters of the serial engine's, and spheres are fetched at the end only`(case: RowCase) {
        val expected = serial(case)
        assertTrue(expected.steps > 3) { "${expected.steps} steps" }
        for (count in listOf(1, 3, 5)) {
            val fleet = ThreadFleet(count) { 1 + it % 2 }
            val asked = ConcurrentHashMap<Command, AtomicInteger>()
            var begin: Begin? = null
            fleet.onSend = { from, _, message ->
                if (from == Mail.LEADER && begin == null) begin = Begin.read(message.duplicate())
                // The first message of a crew and spheres are longer.
                val isQuestion = from == Mail.LEADER && (message.remaining() == 1 || message.remaining() == MEANS)
                if (isQuestion) {
                    val command = Command.entries[message.get(message.position()).toInt()]
                    asked.computeIfAbsent(command) { AtomicInteger() }.incrementAndGet()
                }
            }
            val found = nodes(fleet, case, Output { it.conserved() })
            assertSameRows()
            assertEquals(expected.stateDigest, found.stateDigest)
            assertEquals(expected.energy, found.energy)
            assertEquals(expected.swaps to expected.swapAttempts, found.swaps to found.swapAttempts)
            assertEquals(listOf(1, 1), listOf(fleet.crews, asked.getValue(Command.GATHER).get() / count))
            val steps = expected.steps.toInt() * count
            // The watcher asks once more.
            assertEquals(2 * steps, asked.getValue(Command.FIRST_SUMS).get())
            assertEquals(steps, asked.getValue(Command.CENTRAL_SUMS).get())
            // Collisions are summed by nodes, unless somebody has to see them.
            assertEquals(case == RowCase.PISTONS, begin!!.records)
            assertTrue(begin!!.tally >= 0)
        }
        case.check(rows("nodes", "series.csv").map { it.split(',') })
    }

    @ParameterizedTest
    @EnumSource(
        names = [
            "BODIES", "TREE", "MESH", "GROWING", "PISTONS", "MOONS", "STEPPED", "MERGING", "BREAKING", "SWAPPING",
            "EXCHANGED",
        ],
    )
    fun `rows are the same where nodes die, and what all nodes find together is found again`(case: RowCase) {
        val expected = serial(case, "output.checkpointEvery=4")
        val random = Random(case.ordinal.toLong())
        var lost = 0
        repeat(4) {
            val fleet = ThreadFleet(3) { 1 + it % 2 }
            val left = AtomicInteger(30 + random.nextInt(400))
            val victim = random.nextInt(3)
            fleet.onSend = { _, _, _ -> if (left.decrementAndGet() == 0) fleet.kill(victim) }
            // Copies at some of the steps, so that what is lost is made again from there.
            var looks = 0
            val engines = FleetEngines(fleet, Duration.ZERO, { }, CopyClock { ++looks / 5 * 10_000_000_000L })
            val run = scenario(case, arrayOf("output.checkpointEvery=4"))
            val found = Run.start(run, "test", home.resolve("nodes"), force = true, engines = engines)
                .use { it.execute() }
            assertEquals(expected.stateDigest, found.stateDigest)
            assertSameRows()
            lost += fleet.crews - 1
        }
        assertTrue(lost > 1) { "only $lost were lost" }
    }

    @ParameterizedTest
    @EnumSource(
        names = [
            "TREE", "MESH", "GROWING", "PISTONS", "MOONS", "STEPPED", "MERGING", "BREAKING", "SWAPPING", "EXCHANGED",
        ],
    )
    fun `a run goes on with other nodes and without any, from what each has saved`(case: RowCase) {
        val expected = serial(case, "output.checkpointEvery=2")
        val run = scenario(case, arrayOf("output.checkpointEvery=2", "engine.name=serial"))
        fun nodes(count: Int) = FleetEngines(ThreadFleet(count), Duration.ZERO, { }, CopyClock { 0 })
        val to = home.resolve("nodes")
        Run.start(run, "test", to, force = true, engines = nodes(3)).use {
            it.execute(cancelled = {
                it.simulation.step >=
                    2
            })
        }
        Run.resume(to, engines = Engines).use { it.execute(cancelled = { it.simulation.step >= 4 }) }
        val found = Run.resume(to, engines = nodes(2)).use { it.execute() }
        assertEquals(expected.stateDigest, found.stateDigest)
        assertSameRows()
    }

    @Test
    fun `pieces that get ids of spheres that are gone have crossed no boxes of theirs`() {
        // Spheres that merge and break all the time, and are seen now and then.
        val settings = arrayOf("output.snapshotEvery=1", "until=3", "merging.speed=4", "breaking.speed=5")
        serial(RowCase.BREAKING, *settings)
        nodes(ThreadFleet(3), RowCase.BREAKING, Output { }, *settings)
        val serial = Run.open(home.resolve("serial"))
        val found = Run.open(home.resolve("nodes"))
        var reused = 0
        var highest = -1
        var hasFallen = false
        for (step in serial.steps()) {
            val (one, other) = serial.atStep(step) to found.atStep(step)
            assertArrayEquals(one.id, other.id)
            for (axis in 0..2) assertArrayEquals(one.image!![axis], other.image!![axis]) { "step $step" }
            if (one.id.last() < highest) reused++
            val now = one.id.last()
            if (hasFallen && now > highest) reused++
            hasFallen = now < highest || hasFallen && now == highest
            highest = now
        }
        assertTrue(reused > 1) { "ids were never free again" }
    }

    @Test
    fun `a sphere that came, crossed a face and left between two copies is in nobody's way`() {
        // So many come and leave that ids are far apart.
        val settings = arrayOf(
            "sources=[{\"type\": \"inflow\", \"rate\": 60, \"region\": {\"x\": [0, 15]}, \"sigma\": 1}," +
                "{\"type\": \"outflow\", \"region\": {\"x\": [0, 15], \"y\": [-3, -1]}}," +
                "{\"type\": \"outflow\", \"region\": {\"x\": [-15, -4], \"y\": [-3, 0]}}]",
            "box.lengths=[30,6,6]",
            "particles.count=60",
            "velocities.sigma=1",
            "until=20",
            "output.checkpointEvery=20",
        )
        val expected = serial(RowCase.EMPTIED, *settings)
        val found = nodes(ThreadFleet(2), RowCase.EMPTIED, Output { }, *settings)
        assertEquals(expected.stateDigest, found.stateDigest)
        assertSameRows()
    }

    @Test
    fun `nodes may have hundreds of threads together`() {
        serial(RowCase.WALLS, "until=0.15")
        nodes(ThreadFleet(2) { 136 }, RowCase.WALLS, Output { }, "until=0.15")
        assertSameRows()
    }

    @Test
    fun `a step that fails where spheres grow does so with the same words, and the state before it is kept`() {
        // One sphere grows until it would touch its own image.
        val fails = arrayOf("particles.count=1", "growth={\"rate\": 2}", "until=5.5", "timeStep.dt=0.04")
        assertFails(RowCase.GROWING, "touches its own image", 100, *fails)
    }

    @Test
    fun `so it does where walls are pistons`() {
        val fall = "forces=[{\"type\": \"uniform-acceleration\", \"acceleration\": [300, 0, 0]}]"
        assertFails(RowCase.PISTONS, "images", 3, "boundary.axes=z", fall, "until=5", "particles.count=100")
    }

    private fun assertFails(case: RowCase, words: String, after: Long, vararg settings: String) {
        val serial = assertThrows(RunException::class.java) { serial(case, *settings) }
        val nodes = assertThrows(RunException::class.java) { nodes(ThreadFleet(3), case, Output { }, *settings) }
        assertTrue(words in serial.message!!) { serial.message!! }
        assertEquals(serial.message, nodes.message)
        val states = listOf("serial", "nodes").map { run ->
            Run.resume(home.resolve(run), engines = Engines).use {
                listOf(
                    it.resumedFrom,
                    stateDigest(it.simulation.population),
                    CarriedState(it.simulation.boundary, it.simulation.forces).numbers.toList(),
                )
            }
        }
        assertTrue(states[0][0] as Long > after) { "$states" }
        assertEquals(states[0], states[1])
    }

    @Test
    fun `rows beside snapshots and copies at every step are the same`() {
        serial(RowCase.RING, "output.snapshotEvery=4")
        nodes(ThreadFleet(3), RowCase.RING, Output { }, "output.snapshotEvery=4")
        assertSameRows()
        val fleet = ThreadFleet(2)
        var now = 0L
        val engines = FleetEngines(fleet, Duration.ZERO, { }, CopyClock { now.also { now += 10_000_000_000 } })
        val copied = scenario(RowCase.RING, arrayOf("output.snapshotEvery=4"))
        Run.start(copied, "test", home.resolve("nodes"), force = true, engines = engines).use { it.execute() }
        assertSameRows()
    }

    @Test
    fun `sums of what collisions conserve are those of the population, whoever holds the spheres`() {
        val seen = ArrayList<List<Double>>()
        nodes(
            ThreadFleet(4),
            RowCase.WALLS,
            Output { simulation ->
                val there = simulation.conserved()
                val here = Conserved.of(simulation.population)
                val after = simulation.conserved()
                fun numbers(c: Conserved) =
                    listOf(c.count.toDouble(), c.mass, c.kineticEnergy, c.momentumX, c.momentumY, c.momentumZ)
                assertEquals(numbers(here), numbers(there))
                assertEquals(numbers(here), numbers(after))
                seen += numbers(there)
            },
        )
        assertTrue(seen.distinct().size > 3) { "$seen" }
    }

    private companion object {
        val EVERY_ROW = listOf("output.seriesEvery=1", "output.transportEvery=1")
        const val MEANS = 1 + 11 * Double.SIZE_BYTES + 2 * Int.SIZE_BYTES
    }
}
