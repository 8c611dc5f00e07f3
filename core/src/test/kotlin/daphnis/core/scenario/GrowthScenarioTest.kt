package daphnis.core.scenario

import daphnis.core.boundary.Periodic
import daphnis.core.compression.GrowingSpheres
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineFactory
import daphnis.core.engine.SerialEngine
import daphnis.core.initial.fillingFactor
import daphnis.core.input.InputException
import daphnis.core.run.Run
import daphnis.core.run.RunDirectory
import daphnis.core.run.RunException
import daphnis.core.run.RunOrigin
import daphnis.core.run.Summary
import daphnis.core.run.results
import daphnis.core.run.toStep
import daphnis.core.search.Overlap
import daphnis.core.step.CollapseException
import daphnis.core.step.CollisionStep
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class GrowthScenarioTest {
    @TempDir
    lateinit var home: Path

    private fun scenario(vararg settings: String) = ScenarioJson.parse(
        """{
          "box": { "lengths": [8, 8, 8] }, "boundary": { "type": "periodic" },
          "particles": { "count": 120, "sizes": { "type": "equal", "radius": 0.6 } },
          "velocities": { "type": "gaussian", "sigma": 1 },
          "restitution": { "type": "constant", "coefficient": 1 },
          "growth": { "rate": 0.1 },
          "engine": { "name": "serial" },
          "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 2,
          "output": { "seriesEvery": 1, "checkpointEvery": 3, "snapshotEvery": 4 }
        }""",
        "test",
        settings.toList(),
    )

    private fun refused(vararg settings: String): String = assertThrows(InputException::class.java) {
        ScenarioSetup.of(scenario(*settings), "test")
    }.message.orEmpty().also { assertFalse('\n' in it) { it } }

    @Test
    fun `from any state of it, a run grows on to the same bits, or at another rate over the radii of the state`() {
        for ((name, rate) in listOf("grow" to 0.1, "shrink" to -0.2)) {
            fun run(n: String, from: RunOrigin?, vararg settings: String): Summary =
                Run.start(scenario("growth.rate=$rate", *settings), "test", home.resolve("$name-$n"), from = from)
                    .use { it.execute() }
            val digest = run("whole", null).stateDigest
            val whole = Run.open(home.resolve("$name-whole"))
            for (step in whole.steps().dropLast(1)) {
                assertEquals(digest, run("$step", RunOrigin(whole, whole.atStep(step))).stateDigest) { "step $step" }
            }
            val second = Run.open(home.resolve("$name-4"))
            val again = RunOrigin(second, second.atStep(4))
            for ((n, own) in listOf("b" to second.scenario()!!, "e" to scenario("growth.rate=$rate"))) {
                val third = Run.start(own, "test", home.resolve("$name-$n"), from = again)
                assertEquals(digest, third.use { it.execute() }.stateDigest) { n }
            }
            for ((n, from) in listOf("c" to RunOrigin(whole, whole.atStep(8)), "d" to again)) {
                val start = from.state.radius[0] / 0.6
                assertEquals(1 + rate * 0.8, start, 1e-12)
                run(n, from, "growth.rate=0.05")
                val end = Run.open(home.resolve("$name-$n")).last().radius[0] / 0.6
                assertEquals(start * (1 + 0.05 * 1.2), end, 1e-12)
            }
        }
    }

    @Test
    fun `killed at any step, a run goes on with the same radii, pressure and end`() {
        val settings = arrayOf("growth.untilFillingFactor=0.24", "until=9")
        fun start(name: String) = Run.start(scenario(*settings), "test", home.resolve(name))
        val whole = start("whole").toStep(Long.MAX_VALUE)
        assertTrue(whole.finished && whole.time < 1.5) { "${whole.time}" }
        val expected = results(home.resolve("whole"))
        val series = expected.getValue("series.csv").trim().lines().map { it.split(',') }
        val filling = series[0].indexOfFirst { it.startsWith("filling_factor") }
        val pressure = series[0].indexOfFirst { it.startsWith("reduced_pressure") }
        assertEquals("NaN", series[1][pressure])
        assertTrue(series.drop(2).all { it[pressure].toDouble() > 1 })
        assertTrue(series.last()[filling].toDouble() >= 0.24 && series[series.size - 2][filling].toDouble() < 0.24)
        for (step in listOf(1L, whole.steps - 1)) {
            assertFalse(start("part-$step").toStep(step).finished)
            Run.resume(home.resolve("part-$step")).use { it.execute() }
            assertEquals(expected, results(home.resolve("part-$step"))) { "from step $step" }
        }
        // What has ended stays so, also by the pressure of its last step.
        Run.resume(home.resolve("whole")).use { assertEquals(whole.steps, it.execute().steps) }
    }

    @Test
    fun `a run ends at a pressure, and a resume does not go on from there`() {
        val directory = home.resolve("pressed")
        val end = Run.start(scenario("growth.untilPressure=3.5", "until=9"), "test", directory).toStep(Long.MAX_VALUE)
        assertTrue(end.finished && end.time < 8) { "${end.time}" }
        val rows = Files.readAllLines(directory.resolve("series.csv")).map { it.split(',') }
        val pressure = rows[0].indexOfFirst { it.startsWith("reduced_pressure") }
        assertTrue(rows.last()[pressure].toDouble() >= 3.5)
        assertTrue(rows.drop(2).dropLast(1).all { it[pressure].toDouble() < 3.5 })
        Run.resume(directory).use { assertEquals(end.steps, it.execute().steps) }
        assertEquals(end.stateDigest, Summary.read(RunDirectory(directory).summary).stateDigest)
    }

    @Test
    fun `a resume to where spheres jam or vanish is refused as a start is`() {
        fun refused(rate: String, until: Double): String {
            val directory = home.resolve("rate$rate")
            Run.start(scenario("growth.rate=$rate"), "test", directory).toStep(Long.MAX_VALUE)
            return assertThrows(InputException::class.java) { Run.resume(directory, until).close() }.message.orEmpty()
        }
        refused("0.1", 6.0).let { assertTrue("makes spheres fill 0.8" in it) { it } }
        refused("-0.1", 11.0).let { assertTrue("vanish" in it) { it } }
        Run.resume(home.resolve("rate0.1"), 2.5).use { assertTrue(it.execute().finished) }
    }

    @Test
    fun `a rate of 0 is a run without growth, and steps without a length are no longer than growth allows`() {
        assertTrue(Surroundings.of(scenario("growth.rate=0"), "test").boundary is Periodic)
        assertTrue(ScenarioSetup.of(scenario(), "test").boundary is GrowingSpheres)
        assertFalse("growth" in ScenarioJson.write(scenario("growth=null")))
        val free = ScenarioSetup.of(
            scenario("""timeStep={"type": "automatic"}""", "growth.rate=1", "until=0.2"),
            "test",
        )
        assertTrue(free.timeStep.next(free.population) <= 0.02)
    }

    @Test
    fun `what cannot grow is refused in a line with its key`() {
        assertTrue("growth: needs boundary periodic, and has walls" in refused("boundary={\"type\": \"walls\"}"))
        assertTrue("growth: needs elastic" in refused("restitution.coefficient=0.9"))
        assertTrue(
            "growth: needs smooth" in refused("""roughness={"type": "constant", "coefficient": 0.5}"""),
        )
        val force = """forces=[{"type": "uniform-acceleration", "acceleration": [0, 0, 1]}]"""
        assertTrue("growth: needs spheres on which" in refused(force))
        assertTrue("growth.untilFillingFactor: is 0.75; equal ones" in refused("growth.untilFillingFactor=0.75"))
        assertTrue("at the start" in refused("growth.untilFillingFactor=0.1"))
        assertTrue("growth.untilPressure: is 1" in refused("growth.untilPressure=1"))
        assertTrue("growth.rate: is 0.5; makes spheres fill" in refused("growth.rate=0.5"))
        assertTrue("vanish" in refused("growth.rate=-0.6"))
        assertTrue("growth.since: is -20.0; makes radii" in refused("growth.rate=-0.05", "growth.since=-20"))
        assertTrue("growth.since: is NaN" in refused("growth.since=NaN"))
        assertTrue("growth.rate" in refused("growth.rate=1e999"))
        // γ = 0.45/(1 − 0.45 · 1.9) in the last step.
        assertTrue("growth.rate: is -0.45; shrinks radii by 0.31 of" in refused("growth.rate=-0.45"))
        ScenarioSetup.of(scenario("growth.rate=-0.45", "growth.untilFillingFactor=0.1"), "test")
        val goal = "growth.untilPressure=1000"
        assertTrue("growth.rate: is 1.1; changes radii by more" in refused("growth.rate=1.1", goal))
        assertTrue("growth.rate" in refused(goal, "box.lengths=[250, 4, 1.21]", "particles.count=20"))
    }

    @Test
    fun `a grown placement has the radii that are asked for, and no overlap`() {
        val grown = arrayOf("growth=null", "placement={\"type\": \"grown\"}", "particles.count=280")
        val setup = ScenarioSetup.of(scenario(*grown), "test")
        val p = setup.population
        assertTrue(p.radius.all { it == 0.6 })
        assertTrue(fillingFactor(p.radius, setup.boundary.box) in 0.49..0.5)
        assertEquals(0.0, Overlap.deepest(p, setup.boundary, 0.0).depth)
        ScenarioSetup.check(scenario(*grown), "test")
        val small = arrayOf("box.lengths=[4, 4, 4]")
        val dense = refused(*grown, *small, "particles.count=49")
        assertTrue("particles.count: is 49" in dense && "jam" in dense) { dense }
        refused(*grown, "boundary={\"type\": \"walls\", \"axes\": \"z\"}").let {
            assertTrue("repeats along all" in it) { it }
        }
    }

    @Test
    fun `a state whose spheres overlap a little grows into one that starts, and keeps radii and velocities`() {
        val dense = arrayOf("growth=null", "placement={\"type\": \"grown\"}", "particles.count=250")
        val p = ScenarioSetup.of(scenario(*dense), "test").population
        val rows = (0 until p.size).joinToString("") { k ->
            "$k ${p.x[k].toFloat()} ${p.y[k].toFloat()} ${p.z[k].toFloat()} ${p.vx[k]} ${p.vy[k]} ${p.vz[k]} 0.604 1\n"
        }
        val text =
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n${p.size}\nITEM: BOX BOUNDS pp pp pp\n-4 4\n-4 4\n-4 4\n" +
                "ITEM: ATOMS id x y z vx vy vz radius mass\n$rows"
        val file = Files.writeString(home.resolve("start.dump"), text)
        fun start(boundary: String = "{\"type\": \"periodic\"}") = ScenarioSetup.of(
            ScenarioJson.parse(
                """{ "box": { "lengths": [8, 8, 8] }, "boundary": $boundary,
                "placement": { "type": "file", "path": "$file", "overlaps": "grow" },
                "restitution": { "type": "constant", "coefficient": 1 },
                "timeStep": { "type": "fixed", "dt": 0.01 }, "until": 100 }""",
                "s.json",
            ),
            "s.json",
        )
        val setup = start()
        assertEquals(0.0, Overlap.deepest(setup.population, setup.boundary, 0.0).depth)
        assertTrue(setup.population.radius.all { it == 0.604 })
        assertArrayEquals(p.vx, setup.population.vx)
        assertTrue("grown back" in setup.notices.single()) { "${setup.notices}" }
        val sheared = "{\"type\": \"lees-edwards\", \"shearRate\": 0}"
        val refusal = assertThrows(InputException::class.java) { start(sheared) }.message.orEmpty()
        assertTrue("placement.overlaps: is grow; it needs" in refusal) { refusal }
    }

    @Test
    fun `a share of the sites of a lattice stays empty`() {
        val fcc = arrayOf("growth=null", "particles.count=97", "box.lengths=[6, 6, 6]")
        val placed = ScenarioSetup.of(scenario(*fcc, "placement={\"type\": \"lattice\", \"vacancies\": 0.1}"), "test")
        assertEquals(97, placed.population.size)
        assertTrue("placement.vacancies: is 1" in refused(*fcc, "placement={\"type\": \"lattice\", \"vacancies\": 1}"))
        for (name in listOf("bcc", "hcp")) {
            val text = "placement={\"type\": \"lattice\", \"lattice\": \"$name\"}"
            assertEquals(97, ScenarioSetup.of(scenario(*fcc, text, "box.lengths=[9, 9, 9]"), "test").population.size)
        }
    }

    @Test
    fun `a grown placement to a pressure scales the radii, and says by how much`() {
        fun grown(pressure: Double) = arrayOf("growth=null", """placement={"type": "grown", "pressure": $pressure}""")
        val setup = ScenarioSetup.of(scenario(*grown(4.0)), "test")
        val radius = setup.population.radius[0]
        assertTrue(setup.population.radius.all { it == radius })
        assertEquals(4.0 / 3 * Math.PI * radius * radius * radius, setup.population.mass[0], 1e-12)
        assertTrue(fillingFactor(setup.population.radius, setup.boundary.box) in 0.28..0.34) { "$radius" }
        assertEquals(0.0, Overlap.deepest(setup.population, setup.boundary, 0.0).depth)
        assertTrue("radii are ${radius / 0.6}".take(15) in setup.notices.single()) { "${setup.notices}" }
        // The sizes are proportions.
        ScenarioSetup.check(scenario(*grown(4.0), "particles.sizes.radius=50"), "test")
        assertTrue("placement.pressure: is 1.0; must be > 1" in refused(*grown(1.0)))
        assertTrue("placement.pressure: is 1000.0; must" in refused(*grown(1000.0)))
        val full = """particles={"fillingFactor": 0.3, "sizes": {"type": "equal", "radius": 0.6}}"""
        assertTrue("particles.fillingFactor: follows from placement.pressure" in refused(*grown(4.0), full))
    }

    @Test
    fun `a run that jams ends with its filling factor and what to do`() {
        class Failing(private val e: RuntimeException) : EngineFactory {
            override val names = listOf("serial")

            override fun create(name: String, threads: Int) = object : CollisionEngine by SerialEngine() {
                override fun advance(step: CollisionStep) = throw e
            }
        }
        fun told(e: RuntimeException, growth: String) = assertThrows(RunException::class.java) {
            val directory = home.resolve("jam$growth${e.message}")
            Run.start(scenario(growth), "test", directory, false, Failing(e)).use { it.execute() }
        }.message.orEmpty()
        val jammed = told(CollapseException("no end"), "growth.rate=0.1")
        assertTrue("step 1: jammed at a filling factor of 0.2120575041" in jammed) { jammed }
        assertTrue("(no end); end the run before, with growth.untilFillingFactor or" in jammed) { jammed }
        // With a low pressure the step is too long for something else, and without growth nothing jams.
        assertEquals("step 1: too far", told(IllegalArgumentException("too far"), "growth.rate=0.1"))
        assertEquals("step 1: no end", told(CollapseException("no end"), "growth=null"))
    }
}
