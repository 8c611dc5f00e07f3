package daphnis.core.run

import daphnis.core.Output
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineFactory
import daphnis.core.engine.SerialEngine
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
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

class RunTest {
    @TempDir
    lateinit var home: Path

    /** Lees–Edwards, TC guard and a collision log: everything that a checkpoint has to carry. */
    private fun scenario(vararg settings: String): Scenario = ScenarioJson.parse(
        """{
          "name": "resumable", "seed": 3,
          "box": { "lengths": [9, 9, 9] }, "boundary": { "type": "lees-edwards", "shearRate": 0.7 },
          "particles": { "count": 150,
            "sizes": { "type": "power-law", "minimum": 0.2, "maximum": 0.6, "exponent": 2 } },
          "velocities": { "type": "gaussian", "sigma": 1.0, "shearProfile": true },
          "restitution": { "type": "constant", "coefficient": 0.6 },
          "guard": { "type": "contact-duration", "duration": 0.01 },
          "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 4.0,
          "output": { "snapshotEvery": 8, "checkpointEvery": 5, "collisionLog": true }
        }""",
        "test",
        settings.toList(),
    )

    private fun run(name: String, steps: Int = Int.MAX_VALUE, vararg settings: String): Summary =
        Run.start(scenario(*settings), "test", home.resolve(name)).use { run ->
            run.execute(cancelled = { run.simulation.step >= steps })
        }

    private fun resume(name: String): Pair<Summary, List<String>> = Run.resume(home.resolve(name)).use {
        it.execute() to
            it.notices
    }

    private fun files(name: String) = listOf("series.csv", "collisions.csv").associateWith {
        Files.readString(home.resolve(name).resolve(it))
    }

    @Test
    fun `a run leaves its scenario, states, series, log, checkpoint and summary`() {
        val summary = run("a")
        assertTrue(summary.finished)
        assertEquals(40L, summary.steps)
        assertEquals(4.0, summary.time)
        assertTrue(summary.guardActivations > 0) { "the guard should have had work here" }
        val directory = RunDirectory(home.resolve("a"))
        assertEquals(listOf(0L, 8L, 16L, 24L, 32L, 40L), directory.snapshotSteps())
        assertEquals(42, Files.readAllLines(directory.series).size)
        assertEquals(summary.collisions, Files.readAllLines(directory.collisions).size - 1L)
        assertEquals(summary.stateDigest, Summary.read(directory.summary).stateDigest)
    }

    @Test
    fun `the scenario in the run directory gives the same digest again`() {
        val first = run("a")
        val again = Run.start(ScenarioJson.read(home.resolve("a/scenario.json")), "again", home.resolve("b")).use {
            it.execute()
        }
        assertEquals(first.stateDigest, again.stateDigest)
    }

    @Test
    fun `interrupted at any step and resumed, a run ends in the same digest, series and log`() {
        val whole = run("whole")
        for (steps in listOf(0, 1, 5, 17, 39)) {
            val broken = run("broken$steps", steps)
            assertFalse(broken.finished)
            val (resumed, notices) = resume("broken$steps")
            assertEquals(emptyList<String>(), notices)
            assertEquals(whole.stateDigest, resumed.stateDigest)
            assertEquals(
                listOf(whole.collisions, whole.guardActivations, whole.steps),
                listOf(resumed.collisions, resumed.guardActivations, resumed.steps),
            )
            assertEquals(files("whole"), files("broken$steps"))
            for (step in RunDirectory(home.resolve("whole")).snapshotSteps()) {
                val a = daphnis.core.format.H5md.read(RunDirectory(home.resolve("whole")).snapshot(step)).single()
                val b = daphnis.core.format.H5md.read(
                    RunDirectory(home.resolve("broken$steps")).snapshot(step),
                ).single()
                assertArrayEquals(a.position[0], b.position[0])
                for (axis in 0..2) {
                    assertArrayEquals(a.image!![axis], b.image!![axis]) {
                        "boxes crossed at step $step, broken after $steps"
                    }
                }
                assertTrue(
                    step < 40 ||
                        a.image!!.all { axis ->
                            axis.any { it != 0 }
                        },
                ) { "something should have crossed each face" }
            }
        }
    }

    @Test
    fun `boxes crossed are the same whatever the engine and its threads`() {
        fun images(name: String, vararg settings: String): List<Int> {
            run(name, Int.MAX_VALUE, *settings)
            return daphnis.core.format.H5md.read(
                RunDirectory(home.resolve(name)).snapshot(40),
            ).single().image!!.flatMap {
                it.asList()
            }
        }
        val serial = images("serial", "engine.name=serial")
        for (engine in listOf(
            "islands",
            "thread-pool",
        )) {
            assertEquals(serial, images(engine, "engine.name=$engine", "engine.threads=3")) {
                engine
            }
        }
    }

    @Test
    fun `a ring with gravity, moon and moonlet ends in the same digest, transport and impacts after a resume`() {
        val settings = listOf(
            "box.lengths=[60,60,8]",
            "untilOrbits=0.2",
            "timeStep.steps=200",
            "output.transportEvery=3",
            "output.checkpointEvery=7",
            "bodies=[{\"radius\":8,\"position\":[5,-3,0]}]",
            """forces=[{"type":"self-gravity"},{"type":"satellite","mass":1e6,"x":-25,"y":-30,"radius":6},""" +
                """{"type":"body-gravity"}]""",
        )
        fun ring() = BuiltIn.scenario("self-gravity-wakes", settings)
        val whole = Run.start(ring(), "ring", home.resolve("ring")).use { it.execute() }
        assertTrue(whole.particles < ScenarioSetup.of(ring(), "ring").population.size) {
            "the moon should have swallowed somebody"
        }
        assertTrue(whole.collisions > 20)
        for (steps in listOf(0L, 1L, 7L, 23L)) {
            val name = "ring-broken-$steps"
            Run.start(ring(), "ring", home.resolve(name)).use { run ->
                run.execute(cancelled = {
                    run.simulation.step >=
                        steps
                })
            }
            val resumed = Run.resume(home.resolve(name)).use { it.execute() }
            assertEquals(whole.stateDigest, resumed.stateDigest) { "broken after $steps" }
            for (file in listOf("transport.csv", "impacts.csv", "series.csv")) {
                assertEquals(
                    Files.readString(home.resolve("ring/$file")),
                    Files.readString(home.resolve("$name/$file")),
                ) {
                    "$file, broken after $steps"
                }
            }
        }
    }

    @Test
    fun `what was written after the checkpoint is not there twice`() {
        val whole = run("whole")
        run("broken", 17)
        for (name in listOf("series.csv", "collisions.csv")) {
            Files.writeString(
                home.resolve("broken").resolve(name),
                "17,1.7,half a li",
                java.nio.file.StandardOpenOption.APPEND,
            )
        }
        assertEquals(whole.stateDigest, resume("broken").first.stateDigest)
        assertEquals(files("whole"), files("broken"))
    }

    @Test
    fun `killed before the first checkpoint, resume starts from the scenario`() {
        val whole = run("whole")
        run("broken", 0)
        Files.delete(home.resolve("broken/checkpoint"))
        Files.deleteIfExists(home.resolve("broken/checkpoint.previous"))
        Files.delete(home.resolve("broken/summary.json"))
        assertEquals(whole.stateDigest, resume("broken").first.stateDigest)
        assertEquals(files("whole"), files("broken"))
    }

    @Test
    fun `a run that has gone on and lost both checkpoints does not begin anew without being told to`() {
        val whole = run("whole")
        run("broken")
        for (name in listOf("checkpoint", "checkpoint.previous")) Files.delete(home.resolve("broken").resolve(name))
        val before = files("broken")
        val e = assertThrows(InputException::class.java) { resume("broken") }
        assertTrue(e.wayOut == WayOut.BEGIN_ANEW && "checkpoint" in e.message.orEmpty()) { e.message }
        assertEquals(before, files("broken"))
        Run.resume(home.resolve("broken"), acceptLoss = true).use { run ->
            assertTrue(run.notices.any { "starts again" in it }) { run.notices.toString() }
            assertEquals(whole.stateDigest, run.execute().stateDigest)
        }
    }

    @Test
    fun `killed between the two renames, the previous checkpoint serves`() {
        val whole = run("whole")
        run("broken", 17)
        Files.move(home.resolve("broken/checkpoint"), home.resolve("broken/checkpoint.new"))
        assertEquals(whole.stateDigest, resume("broken").first.stateDigest)
        assertEquals(files("whole"), files("broken"))
    }

    @Test
    fun `a checkpoint cut short or with a flipped bit anywhere is noticed and the one before is used`() {
        val whole = run("whole")
        run("broken", 17)
        val file = home.resolve("broken/checkpoint")
        val good = Files.readAllBytes(file)
        val damages =
            listOf(0, 5, 11, 14, 100, 900, good.size / 2, good.size - 1).map { at ->
                good.copyOf().also {
                    it[at] =
                        (it[at].toInt() xor 0x10).toByte()
                }
            } +
                listOf(0, 3, 12, 40, good.size / 2, good.size - 1).map { good.copyOf(it) }
        for ((k, bytes) in damages.withIndex()) {
            val e = Files.write(home.resolve("damaged$k"), bytes)
            val problem = assertThrows(CheckpointException::class.java) { Checkpoint.read(e) }
            assertFalse('\n' in problem.message.orEmpty())
        }
        Files.write(file, damages[5])
        val (resumed, notices) = resume("broken")
        assertEquals(whole.stateDigest, resumed.stateDigest)
        assertTrue(notices.first().contains("checkpoint") && notices.first().contains("damaged")) { notices.toString() }
        assertEquals(files("whole"), files("broken"))
    }

    @Test
    fun `when both checkpoints are damaged, one line says so`() {
        run("broken", 17)
        for (name in listOf(
            "checkpoint",
            "checkpoint.previous",
        )) {
            Files.write(home.resolve("broken").resolve(name), ByteArray(10))
        }
        val e = assertThrows(InputException::class.java) { resume("broken") }
        assertTrue(e.message.orEmpty().contains("no usable checkpoint is left")) { e.message }
        assertFalse('\n' in e.message.orEmpty())
    }

    @Test
    fun `a run directory that exists is not overwritten without force, and nothing else is with it`() {
        run("a", 3)
        assertThrows(InputException::class.java) { run("a") }
        Run.start(scenario(), "test", home.resolve("a"), force = true).use {
            it.execute(cancelled = {
                it.simulation.step >=
                    2
            })
        }
        Files.createDirectories(home.resolve("mine"))
        Files.writeString(home.resolve("mine/thesis.txt"), "precious")
        val e =
            assertThrows(InputException::class.java) {
                Run.start(scenario(), "test", home.resolve("mine"), force = true)
            }
        assertTrue(e.message.orEmpty().contains("holds no run")) { e.message }
        assertEquals("precious", Files.readString(home.resolve("mine/thesis.txt")))
    }

    @Test
    fun `two processes cannot write into one run`() {
        Run.start(scenario(), "test", home.resolve("a")).use {
            assertThrows(InputException::class.java) { Run.resume(home.resolve("a")) }
        }
    }

    @Test
    fun `a longer end goes on where the run ended`() {
        val long = run("long", Int.MAX_VALUE, "until=6.0")
        run("short")
        val resumed = Run.resume(home.resolve("short"), until = 6.0).use { it.execute() }
        assertEquals(long.stateDigest, resumed.stateDigest)
    }

    @Test
    fun `steps bounded by cell crossing are the same after a resume`() {
        val settings = arrayOf("timeStep={\"type\":\"cell-crossing\",\"fraction\":0.3,\"longest\":0.5}", "until=2.0")
        val whole = run("whole", Int.MAX_VALUE, *settings)
        assertTrue(whole.steps > 5)
        run("broken", 4, *settings)
        assertEquals(whole.stateDigest, resume("broken").first.stateDigest)
    }

    @Test
    fun `an engine that fails ends the run with a checkpoint of the last good step, kicks taken back, to go on from`() {
        val settings = arrayOf("forces=[{\"type\":\"uniform-acceleration\",\"acceleration\":[0,0,-0.3]}]")
        val whole = run("whole", Int.MAX_VALUE, *settings)
        val failing = object : EngineFactory {
            override val names = listOf("failing")

            override fun create(name: String, threads: Int) = object : CollisionEngine {
                private val serial = SerialEngine()
                private var steps = 0
                override val name = "serial"
                override val threads = 1

                override fun advance(step: CollisionStep) {
                    if (++steps == 8) throw RuntimeException("on purpose")
                    serial.advance(step)
                }
            }
        }
        val e =
            assertThrows(RunException::class.java) {
                Run.start(scenario(*settings), "test", home.resolve("broken"), engines = failing).use { it.execute() }
            }
        assertTrue(e.message.orEmpty().contains("step 8") && e.message.orEmpty().contains("on purpose")) { e.message }
        assertEquals(7L, Checkpoint.read(RunDirectory(home.resolve("broken")).checkpoint).meta.step)
        assertEquals(whole.stateDigest, resume("broken").first.stateDigest)
        assertEquals(files("whole"), files("broken"))
    }

    @Test
    fun `an engine is closed when what comes after it cannot be made`() {
        var closed = 0
        val engines = object : EngineFactory {
            override val names = listOf("counting")

            override fun create(name: String, threads: Int) = object : CollisionEngine {
                override val name = "serial"
                override val threads = 1

                override fun advance(step: CollisionStep) = Unit

                override fun close() {
                    closed++
                }
            }
        }
        val outputs = object : Map<String, Output> by emptyMap() {
            override val entries: Set<Map.Entry<String, Output>> get() = throw OutOfMemoryError("on purpose")
        }
        assertThrows(OutOfMemoryError::class.java) {
            Run.start(scenario(), "test", home.resolve("none"), engines = engines, outputs = outputs)
        }
        assertEquals(1, closed)
        assertFalse(Files.exists(home.resolve("none")))
    }

    @Test
    fun `an engine that is not there is named`() {
        val e = assertThrows(InputException::class.java) { run("a", 1, "engine.name=seriel") }
        assertTrue(e.message.orEmpty().contains("engine.name") && e.message.orEmpty().contains("serial"))
        assertThrows(InputException::class.java) { run("b", 1, "engine.name=serial", "engine.threads=2") }
        assertFalse(Files.exists(home.resolve("a"))) { "a refused scenario leaves no directory" }
    }

    @Test
    fun `a scenario that starts from a file keeps the file`() {
        Files.writeString(
            home.resolve("start.csv"),
            "# two\nx, y, z, vx, radius, id\n-2, 0, 0, 1, 0.5, 7\n2,0.1,0,-1,0.5,3\n",
        )
        val text = """{ "box": { "lengths": [9, 9, 9] }, "boundary": { "type": "walls" },
            "placement": { "type": "file", "path": "start.csv" },
            "restitution": { "type": "bridges" }, "timeStep": { "type": "fixed", "dt": 0.5 }, "until": 3 }"""
        val first = Run.start(ScenarioJson.parse(text, "t").atHome(home), "t", home.resolve("a")).use { it.execute() }
        assertTrue(first.collisions > 0)
        Files.delete(home.resolve("start.csv"))
        val again = Run.start(
            ScenarioJson.read(home.resolve("a/scenario.json")).atHome(home.resolve("a")),
            "t",
            home.resolve("b"),
        ).use {
            it.execute()
        }
        assertEquals(first.stateDigest, again.stateDigest)
    }

    @Test
    fun `an engine is told how many steps are to come, to the end`() {
        val told = ArrayList<Long>()
        val serial = SerialEngine()
        val listener = object : CollisionEngine by serial {
            override fun advance(step: CollisionStep) {
                told += step.toCome
                serial.advance(step)
            }
        }
        val engines = object : EngineFactory {
            override val names = listOf("horizon")
            override fun create(name: String, threads: Int) = listener
        }
        val short = scenario("until=1")
        Run.start(short, "test", home.resolve("a"), engines = engines).use {
            it.execute()
            assertEquals(CollisionStep.UNKNOWN, it.simulation.collisions!!.toCome)
        }
        assertEquals((9L downTo 0).toList(), told)
    }
}
