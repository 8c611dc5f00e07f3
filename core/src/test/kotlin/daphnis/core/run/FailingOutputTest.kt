package daphnis.core.run

import daphnis.core.FixedTimeStep
import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.Population
import daphnis.core.randomSpheres
import daphnis.core.scenario.OutputSpec
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.Path
import java.util.concurrent.TimeoutException

/** What comes of an output of one's own that throws, in a run of a scenario and of a program. */
class FailingOutputTest {
    @TempDir
    lateinit var home: Path

    internal class Gas(private val outputs: Map<String, Output>) : Program {
        override val name = "gas"
        override val version = "1"
        override val until = 1.2
        override val output = OutputSpec(snapshotEvery = 4, checkpointEvery = 3)
        private val boundary = Periodic(Box.centred(7.0, 7.0, 7.0))

        override fun population(): Population = randomSpheres(60, boundary, 3, 1.0) { 0.5 }

        override fun simulation(population: Population): Simulation {
            val collisions = CollisionForcing(ConstantRestitution(0.9), recordCollisions = true)
            return Simulation(population, boundary, collisions, FixedTimeStep(0.1))
        }

        override fun outputs(): Map<String, Output> = outputs
    }

    /** Throws what [thrown] has for a phase: in the step 5 when it writes, in the step 6 when it saves. */
    private class Bad(private vararg val thrown: Pair<String, Throwable>) : Output {
        private fun call(phase: String) {
            thrown.find { it.first == phase }?.let { throw it.second }
        }

        private var step = 0L

        override fun open(simulation: Simulation, opening: Opening) = call("open")

        override fun write(simulation: Simulation) {
            step = simulation.step
            if (step == 5L) call("write")
        }

        override fun finish(simulation: Simulation) = call("finish")

        override fun save(state: OutputState) {
            state.put("step", longArrayOf(step))
            if (step == 6L) call("save")
        }

        override fun restore(state: OutputState) = call("restore")

        override fun close() = call("close")
    }

    private val starts = mapOf<String, (Path, Output) -> Run>(
        "scenario" to { path, bad -> Run.start(tableScenario(), "test", path, true, outputs = mapOf("bad" to bad)) },
        "program" to { path, bad -> Run.start(Gas(mapOf("bad" to bad)), path, true) },
    )
    private val resumes = mapOf<String, (Path, Output) -> Run>(
        "scenario" to { path, bad -> Run.resume(path, outputs = mapOf("bad" to bad)) },
        "program" to { path, bad -> Run.resume(Gas(mapOf("bad" to bad)), path) },
    )

    /** Step at which each phase fails. */
    private val steps = mapOf("open" to 0, "write" to 5, "save" to 6, "finish" to 12, "close" to 12)

    private fun failure(run: Run): RunException = run.use { assertThrows(RunException::class.java) { it.execute() } }

    private fun results(of: String): Map<String, String> {
        val path = home.resolve("whole-$of")
        starts.getValue(of)(path, Output { }).use { it.execute() }
        return results(path)
    }

    @Test
    fun `whatever it throws in whatever phase, the run ends with its name, the step and the cause, and can go on`() {
        val kinds = listOf(
            IllegalStateException("broken"),
            IllegalArgumentException("broken"),
            RuntimeException("broken"),
            TimeoutException("broken"),
            RunException("broken"),
            ArithmeticException(),
        )
        for ((of, start) in starts) {
            val whole = results(of)
            for ((phase, step) in steps) {
                val path = home.resolve("$of-$phase")
                for (thrown in if (phase == "write") kinds else kinds.takeLast(1)) {
                    val e = failure(start(path, Bad(phase to thrown)))
                    val words = thrown.message ?: "java.lang.ArithmeticException"
                    assertEquals("step $step: output 'bad': $words", e.message) { "$of, $phase" }
                    assertSame(thrown, e.cause) { "$of, $phase" }
                }
                resumes.getValue(of)(path, Bad()).use { it.execute() }
                assertEquals(whole, results(path)) { "$of, $phase" }
            }
        }
    }

    @Test
    fun `what cannot take over its state ends the resume in the same way, and gives the directory back`() {
        for ((of, start) in starts) {
            val path = home.resolve(of)
            start(path, Bad()).toStep(7)
            val thrown = IllegalStateException("not mine")
            val e = assertThrows(RunException::class.java) {
                resumes.getValue(of)(path, Bad("restore" to thrown)).close()
            }
            assertEquals("step 7: output 'bad' cannot continue from what it saved: not mine", e.message)
            assertSame(thrown, e.cause)
            val reopened = IllegalStateException("shut")
            val later = failure(resumes.getValue(of)(path, Bad("open" to reopened)))
            assertEquals("step 7: output 'bad': shut", later.message)
            resumes.getValue(of)(path, Bad()).use { assertTrue(it.execute().finished) }
        }
    }

    @Tag("thorough")
    @Test
    fun `when it cannot write, that is said as of other files, also from Java`() {
        val io = IOException("no room")
        for ((of, start) in starts) {
            for (phase in steps.keys + "restore") {
                val path = home.resolve("$of-$phase")
                for (thrown in listOf(io, UncheckedIOException(io))) {
                    val bad = Bad(phase to thrown)
                    val e = if (phase == "restore") {
                        start(path, Bad()).toStep(7)
                        assertThrows(RunException::class.java) { resumes.getValue(of)(path, bad).close() }
                    } else {
                        failure(start(path, bad))
                    }
                    assertTrue(e.message.orEmpty().startsWith("cannot write to $path: no room")) { e.message }
                    assertSame(io, e.cause) { "$of, $phase" }
                }
            }
        }
    }

    @Test
    fun `what it throws on closing is kept beside what ended the run`() {
        for ((of, start) in starts) {
            val last = IllegalStateException("cannot close")
            val e = failure(start(home.resolve(of), Bad("write" to RuntimeException("first"), "close" to last)))
            assertEquals("step 5: output 'bad': first", e.message)
            assertSame(last, e.suppressed.single().cause)
        }
    }

    @Test
    fun `when it was interrupted, the thread stays so`() {
        for ((of, start) in starts) {
            val e = failure(start(home.resolve(of), Bad("write" to InterruptedException("by a friend"))))
            assertTrue(Thread.interrupted()) { of }
            assertEquals("step 5: output 'bad': by a friend", e.message)
        }
    }

    @Test
    fun `an error is passed on, and the watcher is named as such`() {
        for ((of, start) in starts) {
            val error = AssertionError("on purpose")
            start(home.resolve(of), Bad("write" to error)).use { run ->
                assertSame(error, assertThrows(AssertionError::class.java) { run.execute() })
            }
            start(home.resolve("$of-watched"), Bad()).use { run ->
                val message = "two\nlines"
                val e = assertThrows(RunException::class.java) {
                    run.execute(Bad("write" to IllegalArgumentException(message)))
                }
                assertEquals("step 5: the watcher: two\\nlines", e.message)
            }
        }
    }
}
