package daphnis.core.run

import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.CollisionRecord
import daphnis.core.population.PopulationSums
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class CollisionLogTest {
    @TempDir
    lateinit var home: Path

    private fun record(size: Int) = CollisionRecord().also { record ->
        repeat(size) { record.add(0.25 * it, 2 * it, 2 * it + 1, CollisionOutcome()) }
    }

    @Test
    fun `collisions that are held back keep their steps, also beside steps without any`() {
        val held = HeldCollisions()
        val sizes = listOf(0, 1, 3, 0, 0, 2, 1, 0)
        for ((step, size) in sizes.withIndex()) held.add(step + 10L, record(size))
        assertEquals(listOf(11L, 12L, 12L, 12L, 15L, 15L, 16L), List(held.size) { held.stepOf(it) })
        assertEquals(listOf(0.0, 0.0, 0.25, 0.5, 0.0, 0.25, 0.0), List(held.size) { held.record.time[it] })
    }

    @Test
    fun `a log is the same whether collisions are held back or not`() {
        val logs = listOf(1, 5, 1_000_000).map { many ->
            val directory = RunDirectory(Files.createDirectories(home.resolve("$many")))
            RunFiles(directory).use { files ->
                CollisionLog(files, CollisionColumns.of(StepSums(PopulationSums(null))), many).use { log ->
                    startIn(home.resolve("run-$many")).use { run -> run.execute(watcher = { log.write(it) }) }
                }
            }
            Files.readString(directory.collisions)
        }
        assertTrue(logs[0].lines().size > 30) { logs[0] }
        assertEquals(logs[0], logs[1])
        assertEquals(logs[0], logs[2])
        assertEquals(logs[0], Files.readString(home.resolve("run-1/collisions.csv")))
    }

    private inline fun CollisionLog.use(act: (CollisionLog) -> Unit) = AutoCloseable { close() }.use { act(this) }
}
