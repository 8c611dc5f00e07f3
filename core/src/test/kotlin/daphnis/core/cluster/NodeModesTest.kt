package daphnis.core.cluster

import daphnis.core.Engines
import daphnis.core.engine.EngineFactory
import daphnis.core.input.InputException
import daphnis.core.run.Run
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration

/** `modes.csv` of a run: the same bytes from every engine, and from nodes. */
@Timeout(120)
class NodeModesTest {
    @TempDir
    lateinit var home: Path

    private fun run(name: String, case: RowCase, engines: EngineFactory, vararg settings: String): String {
        val scenario = ScenarioJson.parse(case.text, "test", settings.asList())
        Run.start(scenario, "test", home.resolve(name), force = true, engines = engines).use { it.execute() }
        return Files.readString(home.resolve("$name/modes.csv"))
    }

    @Test
    fun `modes have the same bytes from engines, threads and nodes, of spheres and beside bodies`() {
        val modes = arrayOf("output.modesEvery=2", "output.modes=3")
        for (case in listOf(RowCase.RING, RowCase.BODIES, RowCase.SHEARED)) {
            val expected = run("serial", case, Engines, "engine.name=serial", *modes)
            val rows = expected.lines().drop(1).filter { it.isNotEmpty() }.map { it.split(',') }
            assertEquals((0..3).map { "$it" }, rows.take(4).map { it[2] })
            assertTrue(rows.size >= 8 && rows.all { row -> row.all { it.toDouble().isFinite() } }) { expected }
            assertEquals(setOf("0"), rows.map { "${it[0].toInt() % 2}" }.toSet())
            assertEquals(expected, run("horizon", case, Engines, "engine.threads=3", *modes))
            val nodes = FleetEngines(ThreadFleet(3), Duration.ZERO, { }, CopyClock { 0 })
            assertEquals(expected, run("nodes", case, nodes, *modes))
        }
    }

    @Test
    fun `what has no modes is refused by its key`() {
        fun refused(case: RowCase, vararg settings: String) =
            assertThrows(InputException::class.java) { run("no", case, Engines, *settings) }.message
        val needs = "needs a box that repeats along x, along which the modes are"
        assertEquals("test: output.modesEvery: $needs", refused(RowCase.OPEN, "output.modesEvery=2"))
        assertEquals("test: output.modesInterval: $needs", refused(RowCase.WALLS, "output.modesInterval=0.1"))
        for (modes in listOf(0, 65)) {
            val range = "must be at least 1 and at most 64"
            assertEquals("test: output.modes: is $modes; $range", refused(RowCase.RING, "output.modes=$modes"))
        }
    }
}
