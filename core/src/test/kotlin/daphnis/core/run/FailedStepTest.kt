package daphnis.core.run

import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineFactory
import daphnis.core.engine.SerialEngine
import daphnis.core.population.stateDigest
import daphnis.core.scenario.ScenarioJson
import daphnis.core.step.CollisionStep
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** The checkpoint of a run whose step fails. */
class FailedStepTest {
    @TempDir
    lateinit var home: Path

    /** Everything of the checkpoint in [name] but the seconds on the wall. */
    private fun checkpoint(name: String): List<Any> = Checkpoint.read(RunDirectory(home.resolve(name)).checkpoint).run {
        val m = meta
        val crossed = List(population.size) { id -> List(3) { population.boxesCrossed(id, it) } }
        val counts = listOf("collisions", "wallCollisions", "guardActivations").map { m.counted.getValue(it) }
        listOf(
            stateDigest(population),
            crossed,
            m.step,
            m.time,
            counts,
            m.appended.mapValues {
                it.value.length to
                    it.value.checksum
            },
        )
    }

    @Test
    fun `when a force fails, kicks of the forces before it are not in the checkpoint, however often it is tried`() {
        // Gravity kicks first, then Hill's frame refuses a step that the time step has made too long.
        val scenario = ScenarioJson.parse(
            """{
              "name": "half", "seed": 1,
              "frame": { "type": "hill", "angularSpeed": 0.1, "verticalFactor": 3.6 },
              "box": { "lengths": [20, 20, 20] }, "boundary": { "type": "hill-sheet" },
              "particles": { "count": 150, "sizes": { "type": "equal", "radius": 0.8 } },
              "velocities": { "type": "gaussian", "sigma": 5.0 },
              "restitution": { "type": "constant", "coefficient": 0.3 },
              "forces": [ { "type": "self-gravity", "constant": 0.0003 } ],
              "timeStep": { "type": "cell-crossing", "fraction": 1.0, "cell": 26, "longest": 1e6 },
              "until": 400, "output": { "checkpointEvery": 1 }
            }""",
            "test",
        )
        val run = Run.start(scenario, "test", home.resolve("half"))
        val message = assertThrows(RunException::class.java) { run.use { it.execute() } }.message!!
        assertTrue("at most a quarter" in message) { message }
        val failed = checkpoint("half")
        assertEquals(checkpointOfGoodStep("half"), failed) {
            "kept after the good step, and again when the next failed"
        }
        repeat(2) {
            assertThrows(RunException::class.java) { Run.resume(home.resolve("half")).use { it.execute() } }
            assertEquals(failed, checkpoint("half"))
        }
    }

    private fun checkpointOfGoodStep(name: String): List<Any> {
        val directory = RunDirectory(home.resolve(name))
        val good = home.resolve("$name.good")
        Files.createDirectories(good)
        Files.copy(directory.previousCheckpoint, RunDirectory(good).checkpoint)
        return checkpoint("$name.good")
    }

    @Test
    fun `an error, too, leaves a checkpoint of the state before the step`() {
        val scenario = ScenarioJson.parse(
            """{
              "name": "error", "seed": 1, "box": { "lengths": [9, 9, 9] }, "boundary": { "type": "periodic" },
              "particles": { "count": 100, "sizes": { "type": "equal", "radius": 0.4 } },
              "velocities": { "type": "gaussian", "sigma": 1.0 },
              "restitution": { "type": "constant", "coefficient": 0.9 },
              "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 2.0, "output": { "checkpointEvery": 0 }
            }""",
            "test",
        )
        var failure: Throwable? = null
        val engines = object : EngineFactory {
            override val names = listOf("serial")

            override fun create(name: String, threads: Int): CollisionEngine {
                val serial = SerialEngine()
                return object : CollisionEngine by serial {
                    override fun advance(step: CollisionStep) {
                        serial.advance(step)
                        if (step.start > 0.95) failure?.let { throw it }
                    }
                }
            }
        }
        fun run(name: String) = Run.start(scenario, "test", home.resolve(name), engines = engines).use { it.execute() }
        failure = StackOverflowError("on purpose")
        assertThrows(StackOverflowError::class.java) { run("error") }
        assertEquals(10L, checkpoint("error")[2])
        failure = null
        val resumed = Run.resume(home.resolve("error"), engines = engines).use { it.execute() }
        assertEquals(run("whole").stateDigest, resumed.stateDigest)
        assertEquals(checkpoint("whole"), checkpoint("error"))
    }
}
