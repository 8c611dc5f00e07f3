package daphnis.core.run

import daphnis.core.Engines
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.input.InputException
import daphnis.core.population.stateDigest
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotSame
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.Collections
import java.util.concurrent.CountDownLatch
import kotlin.concurrent.thread

/** That a run writes on a thread of its own must not show in its files, nor in what it throws. */
@Timeout(120)
class RunWritingTest {
    @TempDir
    lateinit var home: Path

    /** Files written on the thread or, [direct], by the run itself, with something [before] each operation. */
    private open class Disk(
        private val direct: Boolean,
        private val before: (count: Int, operation: String) -> Unit = { _, _ -> },
    ) : FileOperations() {
        val operations = ArrayList<String>()

        override fun writer(): Writer = if (direct) DirectWriter else super.writer()

        @Synchronized
        override fun begin(operation: String) {
            before(operations.size, operation)
            operations += operation
        }
    }

    private fun start(path: Path, files: FileOperations, own: Output = Output { }): Run =
        startRun(tableScenario(), "test", RunDirectory(path, files), true, Engines, mapOf("own" to own))

    /** All files but what tells how long the run took: the summary, and a checkpoint up to its second record. */
    private fun bytes(directory: Path): Map<String, List<Byte>> =
        bytesIn(directory).filterKeys { it != "summary.json" }.mapValues { (name, bytes) ->
            if (!name.startsWith(
                    "checkpoint",
                )
            ) {
                bytes
            } else {
                bytes.drop(String(bytes.toByteArray(), Charsets.ISO_8859_1).indexOf("SCEN"))
            }
        }

    @Test
    fun `every file has the same bytes as without the thread, by the same operations in the same order`() {
        val direct = Disk(direct = true)
        val other = Disk(direct = false)
        start(home.resolve("direct"), direct).use { it.execute() }
        start(home.resolve("thread"), other).use { it.execute() }
        assertEquals(bytes(home.resolve("direct")), bytes(home.resolve("thread")))
        assertTrue(bytes(home.resolve("direct")).keys.containsAll(setOf("checkpoint", "impacts.csv", "collisions.csv")))
        val renamed = direct.operations.map { it.replace("direct", "thread") }
        assertEquals(renamed, other.operations)
    }

    /** What a run throws when the disk fails from operation [n] on; null when it cannot even start. */
    private fun failure(path: Path, direct: Boolean, n: Int): RunException? {
        val disk = Disk(direct) { count, operation ->
            if (count >= n && !operation.startsWith("delete")) throw IOException("full")
        }
        val run = try {
            start(path, disk)
        } catch (e: InputException) {
            return null
        } catch (e: RunException) {
            return null
        }
        return run.use { assertThrows(RunException::class.java) { it.execute() } }
    }

    @Tag("thorough")
    @Test
    fun `a disk that fails at any operation ends the run with the same words, and the run can go on`() {
        val whole = Disk(direct = true).also { disk -> start(home.resolve("whole"), disk).use { it.execute() } }
        val operations = whole.operations.withIndex().map { (n, operation) -> "at $n: $operation" }
        val expected = results(home.resolve("whole"))
        var failures = 0
        for (n in whole.operations.indices) {
            val errors = listOf("direct", "thread").map { failure(home.resolve("$it-$n"), it == "direct", n) }
            assertEquals(errors[0]?.message?.replace("direct-$n", "thread-$n"), errors[1]?.message) { operations[n] }
            if (errors[1] == null) continue
            failures++
            assertEquals("full", errors[1]?.cause?.message)
            val path = home.resolve("thread-$n")
            Run.resume(path).use { it.execute() }
            assertEquals(expected, results(path)) { operations[n] }
        }
        assertTrue(failures > 30) { "$failures" }
    }

    @Test
    fun `the steps go on while a state is written, until a third one would be in memory`() {
        val gate = CountDownLatch(1)
        val begun = CountDownLatch(1)
        val disk = Disk(direct = false) { _, operation ->
            if (operation == "write 0000000004.h5.tmp") {
                begun.countDown()
                gate.await()
            }
        }
        val seen = Collections.synchronizedList(ArrayList<Long>())
        val states = ArrayList<String>()
        val own = Output {
            seen += it.step
            states += stateDigest(it.population)
        }
        val opener = thread {
            begun.await()
            // The checkpoint of step 6 waits for the snapshot of step 4, and with the snapshot of step 8 the run waits.
            while (seen.last() < 7) Thread.sleep(1)
            Thread.sleep(100)
            seen += -1
            gate.countDown()
        }
        start(home.resolve("slow"), disk, own).use { it.execute() }
        opener.join()
        assertEquals((0L..7L) + -1L + (8L..12L), seen.toList())
        val quick = ArrayList<String>()
        start(
            home.resolve("quick"),
            Disk(direct = true),
            Output {
                quick += stateDigest(it.population)
            },
        ).use { it.execute() }
        assertEquals(quick, states) { "an output of one's own sees the state of its step" }
        assertEquals(bytes(home.resolve("quick")), bytes(home.resolve("slow")))
    }

    /** Throws [thrown] in step 5 while the snapshot of step 4 is not yet written, and then lets it be. */
    private class Busy(private val thrown: Throwable) : Output {
        val gate = CountDownLatch(1)

        override fun write(simulation: Simulation) {
            if (simulation.step != 5L) return
            thread {
                Thread.sleep(50)
                gate.countDown()
            }
            throw thrown
        }
    }

    @Test
    fun `when an output throws while the writer is busy, what came before is written first`() {
        val thrown = IllegalStateException("mine")
        val own = Busy(thrown)
        val disk = Disk(direct = false) { _, operation -> if (operation == "write 0000000004.h5.tmp") own.gate.await() }
        val path = home.resolve("busy")
        val e = start(path, disk, own).use { assertThrows(RunException::class.java) { it.execute() } }
        assertEquals("step 5: output 'own': mine", e.message)
        assertSame(thrown, e.cause)
        assertEquals(listOf(0L, 4L), RunDirectory(path).snapshotSteps())
        assertTrue(Files.readString(RunDirectory(path).series).lines().any { it.startsWith("5,") })
    }

    @Test
    fun `when both fail, what comes first in the run is thrown, with its step`() {
        for (failure in listOf(IllegalStateException("no"), IOException("full"))) {
            val own = Busy(IllegalArgumentException("mine"))
            val disk = Disk(direct = false) { _, operation ->
                if (operation == "write 0000000004.h5.tmp") {
                    own.gate.await()
                    throw failure
                }
            }
            val path = home.resolve("both-${failure.message}")
            val e = start(path, disk, own).use { assertThrows(RunException::class.java) { it.execute() } }
            val words = if (failure is IOException) "cannot write to $path: full" else "step 4: output 'snapshots': no"
            assertTrue(e.message!!.startsWith(words)) { e.message }
            assertSame(failure, e.cause)
            val suppressed = (if (failure is IOException) failure else e).suppressed.map { it.message }
            assertEquals(listOf("step 5: output 'own': mine"), suppressed)
        }
    }

    @Test
    fun `an interrupt of the run's thread harms no file, and is still set at the end`() {
        val path = home.resolve("interrupted")
        val own = Output { if (it.step == 5L) Thread.currentThread().interrupt() }
        start(path, FileOperations(), own).use { it.execute() }
        assertTrue(Thread.interrupted())
        start(home.resolve("calm"), FileOperations()).use { it.execute() }
        assertEquals(bytes(home.resolve("calm")), bytes(path))
    }

    @Test
    fun `the outputs of a run are called on its thread, and the thread that writes ends with it`() {
        val here = Thread.currentThread()
        lateinit var writing: Thread
        val disk = Disk(direct = false) { _, operation -> if (".h5" in operation) writing = Thread.currentThread() }
        start(home.resolve("run"), disk, Output { assertSame(here, Thread.currentThread()) }).use { it.execute() }
        assertNotSame(here, writing)
        writing.join()
    }
}
