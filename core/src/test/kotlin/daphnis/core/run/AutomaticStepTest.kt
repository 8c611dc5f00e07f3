package daphnis.core.run

import daphnis.core.Engines
import daphnis.core.FreePathTimeStep
import daphnis.core.Output
import daphnis.core.cluster.FleetEngines
import daphnis.core.cluster.ThreadFleet
import daphnis.core.input.InputException
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.scenario.TimeStepSpec
import daphnis.core.table.UnitsOfDimensions
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration

/** Scenarios that leave the length of a step open. */
class AutomaticStepTest {
    @TempDir
    lateinit var home: Path

    private val gas = """{
        "name": "free", "seed": 3, "box": { "lengths": [9, 9, 9] }, "boundary": { "type": "periodic" },
        "particles": { "count": 120, "sizes": { "type": "equal", "radius": 0.5 }, "mass": 1 },
        "velocities": { "type": "gaussian", "sigma": 1.0 },
        "restitution": { "type": "constant", "coefficient": 0.7 }, "engine": { "name": "serial" }, "until": 2.05,
        "output": { "seriesInterval": 0.3, "snapshotInterval": 0.7, "checkpointInterval": 0.9, "transportInterval": 0.1,
            "collisionLog": true } }"""
    private val sheared =
        arrayOf("boundary={\"type\":\"lees-edwards\",\"shearRate\":0.8}", "velocities.shearProfile=true")

    private fun scenario(vararg settings: String): Scenario = ScenarioJson.parse(gas, "test", settings.toList())

    private fun refusal(vararg settings: String): String = assertThrows(InputException::class.java) {
        ScenarioSetup.of(scenario(*settings), "test")
    }.message.orEmpty()

    private fun column(run: String, file: String, name: String): List<String> {
        val rows = Files.readAllLines(home.resolve(run).resolve(file)).map { it.split(',') }
        return rows.drop(1).map { it[rows[0].map(UnitsOfDimensions::nameIn).indexOf(name)] }
    }

    @Test
    fun `in memory chosen steps know no end, and a gas at rest has steps of one unit`() {
        val setup = ScenarioSetup.of(scenario("until=0.001", "output={}"), "test")
        assertTrue(setup.firstStep() <= 0.001)
        val chosen = setup.endlessTimeStep() as FreePathTimeStep
        assertEquals(Double.POSITIVE_INFINITY, chosen.stops.end)
        val wanted = chosen.next(setup.population)
        assertTrue(wanted > 0.01) { "a step of $wanted" }
        assertEquals(wanted * 1e9, chosen.longest, 1e-6 * chosen.longest)
        val resting = ScenarioSetup.of(scenario("until=500", "velocities.sigma=0"), "test").endlessTimeStep()
        assertEquals(1.0, resting.next(ScenarioSetup.of(scenario("velocities.sigma=0"), "test").population))
        val shear = ScenarioSetup.of(scenario("until=500", *sheared), "test").endlessTimeStep() as FreePathTimeStep
        assertEquals(0.5 / 0.8, shear.longest, 1e-12) { "images slide by half a box at most" }
        val given = ScenarioSetup.of(scenario("timeStep={\"type\":\"fixed\",\"dt\":0.01}"), "test")
        assertTrue(given.endlessTimeStep() === given.timeStep)
    }

    @Test
    fun `rows and states are of the times that are wanted, to the bit, and the run ends when it shall`() {
        startIn(home.resolve("a"), scenario()).toStep(Long.MAX_VALUE)
        val threes = List(7) { it * 0.3 }
        assertEquals(threes, column("a", "series.csv", "time").map { it.toDouble() })
        val transport = column("a", "transport.csv", "time").map { it.toDouble() }
        assertEquals(21, transport.size)
        transport.forEachIndexed { k, time -> assertEquals(k * 0.1, time, 1e-15) }
        val run = RunDirectory(home.resolve("a"))
        assertEquals(listOf(0.0, 0.7, 1.4, 2.05), run.snapshotSteps().map { run.readSnapshot(it).time })
        assertEquals(2.05, Summary.read(run.summary).time)
    }

    @Test
    fun `all engines and nodes give the same bits, sheared or not`() {
        for (settings in listOf(emptyArray(), sheared)) {
            val expected = startIn(home.resolve("serial"), scenario(*settings), force = true).toStep(Long.MAX_VALUE)
            for (engine in Engines.names) {
                val one =
                    scenario(*settings, "engine.name=$engine", "engine.threads=${if (engine == "serial") 1 else 2}")
                val summary = startIn(home.resolve("other"), one, force = true).toStep(Long.MAX_VALUE)
                assertEquals(expected.stateDigest, summary.stateDigest, engine)
                assertEquals(results(home.resolve("serial")), results(home.resolve("other")), engine)
            }
            val fleet = FleetEngines(ThreadFleet(2), Duration.ofSeconds(60))
            val one = scenario(*settings)
            val nodes = Run.start(one, "test", home.resolve("nodes"), true, fleet).use { it.execute() }
            assertEquals(expected.stateDigest, nodes.stateDigest)
            assertEquals(results(home.resolve("serial")), results(home.resolve("nodes")))
        }
    }

    @Tag("thorough")
    @Test
    fun `a run that is broken off anywhere goes on to the same files`() {
        for (settings in listOf(emptyArray(), sheared)) {
            startIn(home.resolve("whole"), scenario(*settings), force = true).toStep(Long.MAX_VALUE)
            for (step in listOf(0L, 1L, 7L, 20L)) {
                startIn(home.resolve("b"), scenario(*settings), force = true).toStep(step)
                Run.resume(home.resolve("b")).use { it.execute() }
                assertEquals(results(home.resolve("whole")), results(home.resolve("b"))) { "$step" }
            }
        }
    }

    @Test
    fun `the scenario in the directory makes the same run, and how often states are wanted is part of it`() {
        val first = startIn(home.resolve("a"), scenario()).toStep(Long.MAX_VALUE)
        val file = home.resolve("a/scenario.json")
        val again = startIn(home.resolve("b"), ScenarioJson.read(file)).toStep(Long.MAX_VALUE)
        assertEquals(first.stateDigest, again.stateDigest)
        assertEquals(Files.readString(file), Files.readString(home.resolve("b/scenario.json")))
        startIn(home.resolve("c"), scenario()).toStep(5)
        fun edit(setting: String) = Files.writeString(
            home.resolve("c/scenario.json"),
            ScenarioJson.write(ScenarioJson.read(home.resolve("c/scenario.json"), listOf(setting))),
        )
        edit("output.checkpointInterval=0.2")
        Run.resume(home.resolve("c")).close()
        edit("output.seriesInterval=0.4")
        val e = assertThrows(InputException::class.java) { Run.resume(home.resolve("c")).close() }
        assertTrue("output.seriesInterval: is 0.4; the run was made with 0.3" in e.message.orEmpty()) { e.message }
    }

    @Test
    fun `from a stop of one run another goes on to the same state, and resume goes on to a later end`() {
        val whole = startIn(home.resolve("whole"), scenario("until=2.1")).toStep(Long.MAX_VALUE)
        startIn(home.resolve("part"), scenario("until=0.9")).toStep(Long.MAX_VALUE)
        val part = RecordedRun(RunDirectory(home.resolve("part")))
        val from = startRun(
            scenario("until=2.1"),
            "test",
            RunDirectory(home.resolve("on")),
            false,
            Engines,
            from = RunOrigin(part, part.last()),
        )
        assertEquals(whole.stateDigest, from.use { it.execute() }.stateDigest)
        assertEquals(whole.stateDigest, Run.resume(home.resolve("part"), 2.1).use { it.execute() }.stateDigest)
    }

    @Test
    fun `a gas that cools gets longer steps`() {
        val times = ArrayList<Double>()
        val long = scenario("until=400", "restitution.coefficient=0.5", "output={\"seriesInterval\":100}")
        startIn(home.resolve("a"), long).use { run -> run.execute(Output { times += it.time }) }
        val lengths = times.zipWithNext { a, b -> b - a }
        assertTrue(lengths.last() > 30 * lengths.first()) { "${lengths.first()} ${lengths.last()}" }
        assertTrue(times.containsAll(listOf(100.0, 200.0, 300.0, 400.0)))
    }

    @Test
    fun `where forces act or faces wait for the end of a step, its length is needed, and a sentence says why`() {
        val fall = "forces=[{\"type\":\"uniform-acceleration\",\"acceleration\":[0,0,-1]}]"
        assertEquals(
            "test: timeStep: is needed, since forces[0] acts at the start and the end of each step; " +
                "give one, such as {\"type\": \"fixed\", \"dt\": 0.01}",
            refusal(fall),
        )
        val paper = "boundary={\"type\":\"sheared-periodic\",\"velocityJump\":1}"
        assertTrue("boundary sheared-periodic brings spheres back at the end of a step" in refusal(paper))
        val ring = arrayOf("frame={\"type\":\"hill\",\"angularSpeed\":1}", "boundary={\"type\":\"hill-sheet\"}")
        assertTrue("orbit-fraction" in refusal(*ring)) { refusal(*ring) }
        assertTrue("timeStep: is needed" in refusal(*ring, "timeStep={\"type\":\"automatic\"}"))
        ScenarioSetup.of(scenario(fall, "timeStep={\"type\":\"fixed\",\"dt\":0.1}"), "test")
    }

    @Test
    fun `one sphere, spheres at rest, tiny and crowded ones, and walls all get steps`() {
        fun steps(vararg settings: String): Long = startIn(home.resolve("a"), scenario(*settings), force = true)
            .toStep(Long.MAX_VALUE).also { assertEquals(2.05, it.time) }.steps
        val seldom = "output={\"seriesEvery\":1}"
        assertTrue(steps("particles.count=1", seldom) in 1..20)
        assertTrue(steps("velocities={\"type\":\"rest\"}", seldom) in 1..3)
        assertTrue(steps("particles.sizes.radius=1e-9", seldom) in 1..100)
        assertTrue(steps("particles.count=500", "placement={\"type\":\"lattice\"}", seldom) in 10..1000)
        assertTrue(steps("boundary={\"type\":\"walls\"}", seldom) in 5..200)
        assertTrue(steps("boundary={\"type\":\"open\"}", seldom) in 1..200)
    }

    @Test
    fun `intervals that are none, too short, of no frame or given twice are refused`() {
        assertEquals("test: output.seriesInterval: is 0.0; must be > 0", refusal("output.seriesInterval=0"))
        assertTrue("there can be" in refusal("output.snapshotInterval=1e-12"))
        assertTrue("needs a frame" in refusal("output.intervalUnit=orbit"))
        assertTrue("timeStep.path" in refusal("timeStep={\"type\":\"automatic\",\"path\":-1}"))
        assertTrue("2.05" in refusal("timeStep={\"type\":\"automatic\",\"path\":1e-300}"))
        val late = "until=1e20"
        val tiny = refusal(late, "output={}", "timeStep={\"type\":\"automatic\",\"path\":1e-5}")
        assertTrue("timeStep.path: is 1.0E-5; makes" in tiny) { tiny }
        val both = "output={\"seriesEvery\":1,\"seriesInterval\":0.5}"
        val sentence = "output.seriesInterval: is given together with seriesEvery; one of the two is enough"
        assertEquals("test: $sentence", refusal(both))
        assertTrue("one of the two" in refusal("output.seriesEvery=2", "output.seriesInterval=0.5"))
        assertNull(scenario("output.seriesEvery=2").output.seriesInterval) { "a setting replaces the other" }
        assertEquals(0.5, scenario("output={\"seriesEvery\":4}", "output.seriesInterval=0.5").output.seriesInterval)
    }

    @Test
    fun `with steps of a given length an output is due after the first step at or after its times`() {
        val fixed = "timeStep={\"type\":\"fixed\",\"dt\":0.2}"
        startIn(home.resolve("a"), scenario(fixed)).toStep(Long.MAX_VALUE)
        val rows = column("a", "series.csv", "step").map { it.toLong() }
        assertEquals(listOf(0L, 2, 3, 5, 6, 8, 9, 11), rows) { "the last, of 2.1, at the end, 2.2" }
        startIn(home.resolve("b"), scenario(fixed, "output={}")).toStep(Long.MAX_VALUE)
        val digests = listOf("a", "b").map { Summary.read(home.resolve("$it/summary.json")).stateDigest }
        assertEquals(digests[1], digests[0]) { "outputs change no step whose length is given" }
    }

    @Test
    fun `intervals can be orbits of the frame`() {
        val ring = scenario(
            "frame={\"type\":\"hill\",\"angularSpeed\":1}",
            "boundary={\"type\":\"hill-sheet\"}",
            "timeStep={\"type\":\"orbit-fraction\",\"steps\":100}",
            "untilOrbits=0.5",
            "output={\"seriesInterval\":0.1,\"intervalUnit\":\"orbit\"}",
        )
        val setup = ScenarioSetup.of(ring, "test")
        assertEquals(0.1 * 2 * Math.PI, setup.scenario.output.seriesInterval)
        startIn(home.resolve("ring"), ring).toStep(Long.MAX_VALUE)
        assertEquals(List(6) { "${10 * it}" }, column("ring", "series.csv", "step"))
    }

    @Test
    fun `the path of a step is kept in the file of the run`() {
        val spec = ScenarioSetup.of(scenario(), "test").scenario.timeStep as TimeStepSpec.Automatic
        val thinner = ScenarioSetup.of(scenario("particles.count=20"), "test").scenario.timeStep
        assertTrue((thinner as TimeStepSpec.Automatic).path!! > spec.path!!)
        val small = ScenarioSetup.of(scenario("box.lengths=[9,9,1.5]", "particles.count=12"), "test").scenario.timeStep
        assertEquals(0.75, (small as TimeStepSpec.Automatic).path) { "half the shortest edge" }
        val shear = arrayOf("boundary={\"type\":\"lees-edwards\",\"shearRate\":-100}", "velocities.shearProfile=true")
        val step = ScenarioSetup.of(scenario(*shear), "test").timeStep as FreePathTimeStep
        assertEquals(0.005, step.longest) { "images slide by half a box" }
        assertEquals(-100.0, step.flow?.rate)
    }
}
