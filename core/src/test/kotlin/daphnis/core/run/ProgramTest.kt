package daphnis.core.run

import daphnis.core.FixedTimeStep
import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.engine.CollisionForcing
import daphnis.core.input.InputException
import daphnis.core.population.Population
import daphnis.core.randomSpheres
import daphnis.core.scenario.OutputSpec
import daphnis.core.search.Overlap
import daphnis.core.surface.Restitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeoutException

/** A sheared gas with a law of its own, every table, and an output that counts. */
private open class ShearedGas(
    override val version: String = "1",
    override val until: Double = 1.2,
    private val names: List<String> = listOf("count"),
) : Program {
    override val name = "sheared gas"
    override val output = OutputSpec(1, 4, 3, true, 2)
    private val boundary = LeesEdwards(Box.centred(7.0, 7.0, 7.0), 0.7)
    val counts = names.associateWith { Count() }

    // At this time the images of spheres at the faces are not where they were placed.
    override fun population(): Population = generateSequence(3L) { it + 1 }
        .map { seed -> randomSpheres(60, boundary, seed, 1.0) { 0.5 } }
        .first { Overlap.deepest(it, boundary, START).depth == 0.0 }

    override fun simulation(population: Population): Simulation {
        val collisions = CollisionForcing(Restitution { 1 / (1 + it) }, recordCollisions = true)
        return Simulation(population, boundary, collisions, FixedTimeStep(0.1), startTime = START)
    }

    override fun outputs(): Map<String, Output> = counts
}

private const val START = 0.5

/** Counts steps and collisions over resumes, in whole and other numbers. */
private class Count : Output {
    var steps = 0L
    var sum = Double.NaN
    val calls = ArrayList<String>()

    override fun open(simulation: Simulation, opening: Opening) {
        calls += "open $opening at ${simulation.step}"
    }

    override fun write(simulation: Simulation) {
        steps++
        sum = (if (sum.isNaN()) 0.1 else sum) + simulation.collisions!!.record!!.size / 3.0
    }

    override fun finish(simulation: Simulation) {
        calls += "finish at ${simulation.step}"
    }

    override fun save(state: OutputState) {
        state.put("steps", longArrayOf(steps))
        state.put("sum", doubleArrayOf(sum))
    }

    override fun restore(state: OutputState) {
        calls += "restore"
        steps = state.longs("steps").single()
        sum = state.doubles("sum").single()
    }

    override fun close() {
        calls += "close"
    }
}

class ProgramTest {
    @TempDir
    lateinit var home: Path

    private val wholeProgram = ShearedGas()
    private val whole by lazy {
        Run.start(wholeProgram, home.resolve("whole")).use { it.execute() }
        results(home.resolve("whole"))
    }

    private fun broken(name: String, step: Long = 5, program: Program = ShearedGas()): Path =
        home.resolve(name).also { Run.start(program, it).toStep(step) }

    private fun refusal(path: Path, program: Program = ShearedGas()): String {
        val before = bytesIn(path)
        val message = assertThrows(InputException::class.java) { Run.resume(program, path).close() }.message.orEmpty()
        assertFalse('\n' in message) { message }
        assertEquals(before, bytesIn(path)) { "a refused resume changes nothing" }
        return message
    }

    @Test
    fun `interrupted after any step and resumed, a program ends in the same state, tables and sums of its own`() {
        assertTrue(Summary.read(home.resolve("whole").also { whole }.resolve("summary.json")).collisions > 20)
        val count = wholeProgram.counts.getValue("count")
        assertEquals(listOf("open START at 0", "finish at 7", "close"), count.calls)
        for (step in 0L..7L) {
            val path = broken("broken-$step", step)
            val resumed = ShearedGas()
            Run.resume(resumed, path).use {
                assertEquals(emptyList<String>(), it.notices)
                it.execute()
            }
            assertEquals(whole, results(path)) { "broken after $step" }
            val again = resumed.counts.getValue("count")
            assertEquals(listOf("restore", "open RESUME at $step", "finish at 7", "close"), again.calls)
            assertEquals(count.steps to count.sum, again.steps to again.sum)
        }
    }

    @Tag("thorough")
    @Test
    fun `killed between two operations on files, a program goes on to the same files`() {
        // Every third: ResumeTest has them all, with a scenario.
        var n = 0
        while (true) {
            val path = home.resolve("killed-$n")
            try {
                startRun(ShearedGas(), RunDirectory(path, MortalFiles(n)), false).toStep(Long.MAX_VALUE)
                break
            } catch (e: Killed) {
                n += 3
            }
            if (Files.exists(path.resolve("run.json"))) {
                Run.resume(ShearedGas(), path).toStep(Long.MAX_VALUE)
            } else {
                Run.start(ShearedGas(), path).toStep(Long.MAX_VALUE)
            }
            assertEquals(whole, results(path)) { "killed before operation ${n - 3}" }
        }
        assertTrue(n > 30) { "$n operations" }
    }

    @Test
    fun `another program, another version and a scenario's run are refused by name`() {
        val path = broken("mine")
        assertTrue("version '1'; this is the program 'sheared gas', version '2'" in refusal(path, ShearedGas("2")))
        val other = object : Program by ShearedGas() {
            override val name = "other"
        }
        assertTrue("this is the program 'other'" in refusal(path, other))
        Files.writeString(path.resolve("run.json"), Files.readString(path.resolve("run.json")).replace("gas", "other"))
        assertTrue("'sheared other'" in refusal(path)) { "run.json was edited" }
        val scenario = home.resolve("scenario").also { startIn(it).toStep(4) }
        assertTrue("a run of a scenario" in refusal(scenario))
        val message = assertThrows(InputException::class.java) { Run.resume(path) }.message.orEmpty()
        assertTrue("holds a run of the program 'sheared other'" in message) { message }
    }

    @Test
    fun `a run json that was damaged is one line`() {
        val path = broken("damaged")
        val more = "{\"program\": \"sheared gas\", \"version\": \"1\", \"x\": 1}"
        for (text in listOf("", "{", "[]", "{\"program\": 3}", more)) {
            Files.writeString(path.resolve("run.json"), text)
            assertTrue("run.json: does not name a program" in refusal(path)) { text }
        }
        Files.write(path.resolve("run.json"), byteArrayOf(0x22, 0xff.toByte()))
        assertTrue("run.json: cannot be read" in refusal(path))
    }

    @Test
    fun `an output that is new begins anew, one that is gone is said to be dropped`() {
        val path = broken("outputs")
        val other = ShearedGas(names = listOf("other"))
        Run.resume(other, path).use {
            assertTrue("output 'count' is no longer there" in it.notices.single()) { "${it.notices}" }
            it.execute()
        }
        assertEquals(2L, other.counts.getValue("other").steps) { "steps 6 and 7" }
        assertEquals(whole["digest"], results(path)["digest"])
    }

    @Test
    fun `an output that cannot take over what was saved ends the resume in one line`() {
        val path = broken("unfit")
        val unfit = object : ShearedGas() {
            override fun outputs(): Map<String, Output> = mapOf(
                "count" to object : Output {
                    override fun write(simulation: Simulation) = Unit

                    override fun restore(state: OutputState) {
                        state.doubles("steps")
                    }
                },
            )
        }
        val before = bytesIn(path)
        val e = assertThrows(RunException::class.java) { Run.resume(unfit, path).close() }
        val why = "'steps' in the saved state of output 'count' is not doubles"
        assertEquals("step 5: output 'count' cannot continue from what it saved: $why", e.message)
        assertEquals(before, bytesIn(path)) { "a refused resume changes nothing" }
        Run.resume(ShearedGas(), path).toStep(Long.MAX_VALUE)
        assertEquals(whole, results(path)) { "the lock was given back" }
    }

    @Test
    fun `a later end goes on, one that is past is refused`() {
        val path = broken("later", Long.MAX_VALUE)
        Run.resume(ShearedGas(until = 1.5), path).use { assertEquals(10, it.execute().steps) }
        assertTrue("the run is at time 1.5" in refusal(path, ShearedGas(until = 1.3)))
    }

    @Test
    fun `a simulation that is not as a run needs it is refused before there is a directory`() {
        fun refused(what: String, make: ShearedGas.(Population) -> Simulation) {
            val program = object : ShearedGas() {
                override fun simulation(population: Population) = make(population)
            }
            val path = home.resolve("refused")
            val e = assertThrows(IllegalArgumentException::class.java) { Run.start(program, path) }
            assertTrue(what in e.message.orEmpty()) { e.message.orEmpty() }
            assertFalse(Files.exists(path))
        }
        val boundary = LeesEdwards(Box.centred(7.0, 7.0, 7.0), 0.7)
        val elastic = Restitution { 1.0 }
        fun plain(
            p: Population,
            outputs: List<Output> = emptyList(),
            step: Long = 0,
            records: Boolean = true,
            start: Double = 0.0,
        ): Simulation {
            val collisions = CollisionForcing(elastic, recordCollisions = records)
            val timeStep = FixedTimeStep(0.1)
            return Simulation(p, boundary, collisions, timeStep, emptyList(), outputs, start, step)
        }
        refused("another population") { plain(population()) }
        refused("has outputs") { plain(it, outputs = listOf(Output { })) }
        refused("has made 3 steps") { plain(it, step = 3) }
        refused("recordCollisions") { plain(it, records = false) }
        refused("must be later than its start, 5.0") {
            plain(it, start = 5.0)
        }
        val taken = ShearedGas(names = listOf("series"))
        assertThrows(IllegalArgumentException::class.java) { Run.start(taken, home.resolve("refused")) }
    }

    @Test
    fun `a program takes the place of a scenario's run and the other way round, with force only`() {
        val path = home.resolve("both").also { startIn(it).toStep(4) }
        assertThrows(InputException::class.java) { Run.start(ShearedGas(), path) }
        Run.start(ShearedGas(), path, force = true).toStep(Long.MAX_VALUE)
        assertFalse(Files.exists(path.resolve("scenario.json")))
        assertEquals(whole, results(path))
        assertThrows(InputException::class.java) { startIn(path) }
        startIn(path, force = true).toStep(4)
        assertFalse(Files.exists(path.resolve("run.json")))
        Run.resume(path).use { it.execute() }
    }

    @Test
    fun `a scenario's run keeps what further outputs save, and is carried out once`() {
        val path = home.resolve("scenario")
        val first = Count()
        Run.start(tableScenario(), "test", path, outputs = mapOf("count" to first)).use { run ->
            run.execute(cancelled = { run.simulation.step >= 7 })
            assertThrows(IllegalStateException::class.java) { run.execute() }
        }
        val second = Count()
        Run.resume(path, outputs = mapOf("count" to second)).use { it.execute() }
        assertEquals(13L, second.steps)
        assertEquals(8L, first.steps)
    }

    @Test
    fun `an output that throws ends the run, is closed, and its step is not in the checkpoint`() {
        val path = home.resolve("thrown")
        val program = ShearedGas()
        val run = Run.start(program, path)
        val watcher = Output { if (it.step == 5L) throw java.io.IOException("no room") }
        val message = run.use { assertThrows(RunException::class.java) { it.execute(watcher) } }.message.orEmpty()
        assertTrue("no room" in message && "then resume" in message) { message }
        assertEquals(listOf("open START at 0", "close"), program.counts.getValue("count").calls)
        val resumed = ShearedGas()
        Run.resume(resumed, path).use {
            assertEquals(3L, it.resumedFrom)
            it.execute()
        }
        assertEquals(whole, results(path))
        assertEquals(8L, resumed.counts.getValue("count").steps)
    }

    @Test
    fun `a checked exception in a step, which Kotlin may throw, ends the run like any other`() {
        var seen = 0
        val program = object : ShearedGas() {
            override fun simulation(population: Population): Simulation {
                val made = super.simulation(population)
                // Within step 4, which has the 15th to the 17th.
                val law = Restitution { if (++seen == 16) throw TimeoutException("out of hours") else 1 / (1 + it) }
                val collisions = CollisionForcing(law, recordCollisions = true)
                return Simulation(population, made.boundary, collisions, FixedTimeStep(0.1), startTime = START)
            }
        }
        val path = home.resolve("checked")
        val e = Run.start(program, path).use { assertThrows(RunException::class.java) { it.execute() } }
        assertEquals("step 4: out of hours", e.message)
        Run.resume(ShearedGas(), path).use { it.execute() }
        assertEquals(whole, results(path))
    }
}
