package daphnis.core.run

import daphnis.core.Output
import daphnis.core.format.FormatException
import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption

class RecordedRunTest {
    @TempDir
    lateinit var home: Path

    private val directory get() = home.resolve("a")

    private fun refused(work: () -> Unit, vararg words: String) {
        val e = assertThrows(InputException::class.java) { work() }
        for (word in words) assertTrue(word in e.message.orEmpty()) { "'$word' is not in ${e.message}" }
    }

    @Test
    fun `states come in the order of time, and by step and by time`() {
        startIn(directory).use { it.execute() }
        val run = Run.open(directory)
        assertEquals(listOf(0L, 4L, 8L, 12L), run.steps())
        assertEquals(run.steps(), run.states().map { it.step })
        // Each iterator begins anew.
        assertEquals(4, run.states().count())
        assertEquals(4, run.states().count())
        for (state in run.states()) {
            val other = run.atStep(state.step)
            assertEquals(state.position[0].asList(), other.position[0].asList())
            assertEquals(state.step, run.at(state.time).step)
            assertEquals(state.step, run.at(state.time * (1 + 1e-12)).step)
        }
        assertEquals(12L, run.last().step)
        assertEquals("tables", run.scenario()?.name)
        assertEquals(true, run.summary()?.finished)
    }

    @Test
    fun `a step or a time without a state is refused with those that there are`() {
        startIn(directory).use { it.execute() }
        val run = Run.open(directory)
        refused({ run.atStep(5) }, "no state after step 5", "0, 4, 8, 12")
        refused({ run.at(0.5) }, "time 0.5;", "step 4, time 0.4", "step 8, time 0.8")
        refused({ run.at(-1.0) }, "time -1;", "step 0, time 0")
        refused({ run.at(7.0) }, "time 7;", "time 1.2")
        refused({ Run.open(home) }, "no run directory")
        refused({ Run.open(home.resolve("nothing")) }, "no such file")
        Run.start(tableScenario("output.snapshotEvery=1"), "test", home.resolve("b")).use { it.execute() }
        refused({ Run.open(home.resolve("b")).atStep(70) }, "13, from 0, 1, … to 12")
    }

    @Test
    fun `a state or a summary of another run of the same name is refused, also after a resume`() {
        val other = home.resolve("other")
        startIn(directory).toStep(7)
        Run.resume(directory).use { it.execute() }
        startIn(other, tableScenario("seed=4")).use { it.execute() }
        val (here, there) = listOf(directory, other).map { RunDirectory(it) }
        for (step in here.snapshotSteps()) {
            val own = Files.readAllBytes(here.snapshot(step))
            Files.copy(there.snapshot(step), here.snapshot(step), StandardCopyOption.REPLACE_EXISTING)
            val e = assertThrows(FormatException::class.java) { Run.open(directory).atStep(step) }
            assertTrue("is a state of another run" in e.message!!) { e.message }
            Files.write(here.snapshot(step), own)
        }
        assertEquals(4, Run.open(directory).states().count())
        // A run may be thinned out.
        Files.delete(here.snapshot(4))
        assertEquals(3, Run.open(directory).states().count())
        Files.copy(there.summary, here.summary, StandardCopyOption.REPLACE_EXISTING)
        assertThrows(FormatException::class.java) { Run.open(directory).summary() }
        assertTrue(RunRecord.of(here).hasEnded)
    }

    @Test
    fun `impacts of another run, in one that was killed, are known for what they are`() {
        startIn(directory).use { run -> run.execute(cancelled = { run.simulation.step >= 7 }) }
        val here = RunDirectory(directory)
        assertFalse(RunRecord.of(here).isNewer(here.impacts))
        // As after a kill: a checkpoint in mid-run is the last.
        Files.delete(here.checkpoint)
        Files.move(here.previousCheckpoint, here.checkpoint)
        Files.delete(here.summary)
        Files.writeString(here.impacts, "another run's")
        assertFalse(RunRecord.of(here).hasEnded)
        assertTrue(RunRecord.of(here).isNewer(here.impacts))
    }

    @Test
    fun `a run that goes on is read as far as it is, its last state from the checkpoint`() {
        startIn(directory).use { run ->
            val reader = Run.open(directory)
            assertEquals(emptyList<Long>(), reader.steps())
            refused({ reader.last() }, "no state yet")
            assertNull(reader.summary())
            // A snapshot every 4 steps and a checkpoint every 3, the latter after outputs have been called.
            val expected = mapOf(
                3L to listOf(0L),
                4L to listOf(0L, 4L),
                7L to listOf(0L, 4L, 6L),
                11L to listOf(0L, 4L, 8L, 9L),
                12L to listOf(0L, 4L, 8L, 12L),
            )
            var looked = 0
            run.execute(
                Output { simulation ->
                    val steps = expected[simulation.step] ?: return@Output
                    assertEquals(steps, written(reader, steps.last()))
                    looked++
                },
            )
            assertEquals(expected.size, looked)
        }
    }

    /** The steps of the states that [reader] finds when that of [last] is written: a run writes on its own thread. */
    private fun written(reader: RecordedRun, last: Long): List<Long> {
        val deadline = System.nanoTime() + 60_000_000_000
        while (true) {
            val steps = reader.states().map { it.step }
            if (last in steps || System.nanoTime() > deadline) return steps
            Thread.sleep(5)
        }
    }

    @Test
    fun `the state of a checkpoint is that of a snapshot of the same step`() {
        Run.start(tableScenario("output.snapshotEvery=1"), "test", directory).toStep(7)
        val run = Run.open(directory)
        val snapshot = run.atStep(7)
        Files.delete(run.directory.snapshot(7))
        val kept = run.atStep(7)
        assertEquals(listOf(snapshot.time, snapshot.shearOffset), listOf(kept.time, kept.shearOffset))
        for (axis in 0..2) {
            assertEquals(snapshot.position[axis].asList(), kept.position[axis].asList())
            assertEquals(snapshot.velocity[axis].asList(), kept.velocity[axis].asList())
            assertEquals(snapshot.image!![axis].asList(), kept.image!![axis].asList())
        }
        assertEquals(snapshot.mass.asList(), kept.mass.asList())
        assertEquals(snapshot.lengths.asList(), kept.lengths.asList())
        assertEquals(7L, run.last().step)
    }

    @Test
    fun `states are read one at a time, so the first of many is there when a later one is damaged`() {
        startIn(directory).use { it.execute() }
        val run = Run.open(directory)
        flip(run.directory.snapshot(8), 3000)
        val states = run.states().iterator()
        assertEquals(0L, states.next().step)
        assertEquals(4L, states.next().step)
        assertThrows(RuntimeException::class.java) { states.next() }
        flip(run.directory.path.resolve("checkpoint"), 200)
        refused({ run.last() }, "checkpoint", "damaged")
        assertFalse(run.atStep(4).size == 0)
    }
}
