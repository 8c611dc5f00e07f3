package daphnis.core.run

import daphnis.core.Interval
import daphnis.core.Repository
import daphnis.core.input.InputException
import daphnis.core.scenario.IntervalUnit
import daphnis.core.scenario.OutputSpec
import daphnis.core.scenario.ScenarioJson
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.descriptors.elementNames
import kotlinx.serialization.json.Json
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

private val COURSE = Course(12.0, 0.0, 1.2)

/** What is true of every output that a key asks for, and what the docs say of it. */
@OptIn(ExperimentalSerializationApi::class)
class PeriodicOutputsTest {
    @TempDir
    lateinit var home: Path

    private val all = PeriodicOutputs.all

    private fun scenario(steps: Int) = tableScenario(*all.map { setting(it, steps) }.toTypedArray())

    /** The rows of the first table below [heading] in [doc], by what the first column has between backticks. */
    private fun rows(doc: String, heading: String): Map<String, List<String>> = Repository.read(doc).lines()
        .dropWhile { it != heading }.dropWhile { !it.startsWith("|") }.drop(2).takeWhile { it.startsWith("|") }
        .map { row -> row.split('|').map { it.trim() } }
        .flatMap { cells -> Regex("`([^`]+)`").findAll(cells[1]).map { it.groupValues[1] to cells } }.toMap()

    @Test
    fun `the list is in the order of the keys, and every key but that of checkpoints has its output`() {
        assertEquals(listOf("series", "snapshots", "collisions", "transport"), all.map { it.name }.take(4))
        val keys = OutputSpec.serializer().descriptor.elementNames.toList()
        val own = setOf("checkpointEvery", "checkpointInterval", "intervalUnit", "modes")
        assertEquals(keys.toSet() - own, all.flatMap { listOfNotNull(it.key, it.intervalKey) }.toSet())
        assertEquals(keys.filter { key -> all.any { it.key == key } }, all.map { it.key })
        assertEquals(all.size, all.map { it.name }.toSet().size)
        val files = all.flatMap { it.files + listOfNotNull(it.folder) }
        assertEquals(files.size, files.toSet().size) { "$files" }
    }

    @Test
    fun `the page of runs has a row for every file and folder`() {
        val told = rows("docs/runs.md", "## The run directory").keys
        for (file in all.flatMap { it.files }) assertTrue(file in told) { "docs/runs.md: no row for $file" }
        for (folder in PeriodicOutputs.folders) assertTrue(told.any { it.startsWith("$folder/") }) { folder }
    }

    @Test
    fun `a run writes what its outputs declare and nothing more, and a new run removes it`() {
        val path = home.resolve("run")
        startIn(path, scenario(1)).toStep(Long.MAX_VALUE)
        val run = setOf("scenario.json", "checkpoint", "checkpoint.previous", "summary.json", ".lock")
        val declared = all.flatMap { it.files }.toSet() + PeriodicOutputs.folders
        assertEquals(run + declared, path.listDirectoryEntries().map { it.name }.toSet())
        for (folder in PeriodicOutputs.folders) assertTrue(path.resolve(folder).listDirectoryEntries().isNotEmpty())
        Files.createDirectories(path.resolve("plots"))
        startIn(path, tableScenario(), force = true).close()
        val left = setOf("scenario.json", ".lock", "plots") + PeriodicOutputs.folders
        assertEquals(left, path.listDirectoryEntries().map { it.name }.toSet())
        for (folder in PeriodicOutputs.folders) assertEquals(0, path.resolve(folder).listDirectoryEntries().size)
    }

    @Test
    fun `with every key at 0, what is written is headers and the final state`() {
        val path = home.resolve("none")
        startIn(path, scenario(0)).toStep(Long.MAX_VALUE)
        for (file in all.flatMap { it.files }.filter { Files.exists(path.resolve(it)) }) {
            assertEquals(1, Files.readAllLines(path.resolve(file)).size) { file }
        }
        assertTrue(Files.exists(path.resolve("series.csv")))
        assertFalse(Files.exists(path.resolve("transport.csv")))
        assertEquals(listOf(12L), RunDirectory(path).snapshotSteps())
        for (output in all) {
            val cost = output.cost(OutputTimes(0, null), COURSE, 60)
            assertEquals(if (output.name == "snapshots") 1.0 else 0.0, cost?.count ?: 0.0) { output.name }
        }
    }

    @Test
    fun `costs are those of what a run writes`() {
        assertEquals(listOf(5.0, 5.0, null, 5.0), all.take(4).map { it.cost(OutputTimes(3, null), COURSE, 60)?.count })
        val snapshots = all.first { it.name == "snapshots" }
        val five = OutputTimes(5, null)
        assertEquals(4.0, snapshots.cost(five, COURSE, 60)?.count) { "0, 5, 10 and the last" }
        assertEquals(4.0 * (63 * 60 + 3100), snapshots.cost(five, COURSE, 60)?.bytes)
        fun inTime(length: Double) = snapshots.cost(OutputTimes(0, Interval(length)), COURSE, 60)?.count
        assertEquals(listOf(5.0, 4.0, 2.0), listOf(0.3, 0.5, 2.0).map { inTime(it) }) { "the last is one of 0.3" }
        assertEquals(13.0, inTime(1e-3)) { "no more than there are steps" }
    }

    @Test
    fun `a number of steps below 0 is refused by its key, in a scenario and in a program`() {
        for (key in OutputSpec().steps().keys) {
            val refused = assertThrows(InputException::class.java) {
                startIn(home.resolve("refused"), tableScenario("output.$key=-1"))
            }
            assertEquals("test: output.$key: is -1; must be at least 0 (0 for never)", refused.message)
            val spec = Json.decodeFromString(OutputSpec.serializer(), """{"$key":-1}""")
            val program = object : Program by FailingOutputTest.Gas(emptyMap()) {
                override val output = spec
            }
            val e = assertThrows(IllegalArgumentException::class.java) { Run.start(program, home.resolve("refused")) }
            assertEquals("output.$key is -1; it must be at least 0", e.message)
            assertFalse(Files.exists(home.resolve("refused")))
        }
    }

    @Test
    fun `a program can have its files at intervals of time`() {
        fun gas(spec: OutputSpec) = object : Program by FailingOutputTest.Gas(emptyMap()) {
            override val output = spec
        }
        val path = home.resolve("gas")
        Run.start(gas(OutputSpec(seriesInterval = 0.5, snapshotInterval = 0.4)), path).use { it.execute() }
        assertEquals(listOf(0L, 4, 8, 12), RunDirectory(path).snapshotSteps())
        val rows = Files.readAllLines(path.resolve("series.csv")).drop(1)
        assertEquals(listOf("0", "5", "10"), rows.map { it.substringBefore(',') })
        val refused = mapOf(
            "output.seriesInterval is -1.0; must be > 0" to OutputSpec(seriesInterval = -1.0),
            "output.snapshotInterval is given together with snapshotEvery; one of the two is enough" to
                OutputSpec(snapshotEvery = 3, snapshotInterval = 1.0),
            "output.snapshotInterval is 1.0E-10 in time; the run goes to time 1.2, 1.2E10 intervals, and there " +
                "can be 1.0E9" to OutputSpec(snapshotInterval = 1e-10),
            "output.intervalUnit is orbit; it needs a HillFrame" to
                OutputSpec(seriesInterval = 1.0, intervalUnit = IntervalUnit.ORBIT),
        )
        for ((message, spec) in refused) {
            val e = assertThrows(IllegalArgumentException::class.java) { Run.start(gas(spec), home.resolve("no")) }
            assertEquals(message, e.message)
        }
    }

    @Tag("thorough")
    @Test
    fun `a resume may write rows and states more or less often, and log, transport and modes neither begin nor end`() {
        for (output in all) {
            val path = home.resolve(output.name)
            for ((then, now) in listOf(0 to 2, 2 to 0, 1 to 2)) {
                startIn(path, tableScenario(setting(output, then)), force = true).toStep(4)
                val edited = ScenarioJson.read(path.resolve("scenario.json"), listOf(setting(output, now)))
                Files.writeString(path.resolve("scenario.json"), ScenarioJson.write(edited))
                val isOneOrOther = then > 0 != now > 0
                if (output.name in setOf("collisions", "transport", "modes") && isOneOrOther) {
                    val e = assertThrows(InputException::class.java) { Run.resume(path).close() }
                    assertTrue("output.${output.key}" in e.message.orEmpty()) { e.message }
                } else {
                    Run.resume(path).use { it.execute() }
                }
            }
        }
    }

    @Test
    fun `a resume may not change how many modes there are`() {
        val path = home.resolve("modes")
        startIn(path, tableScenario("output.modes=7"), force = true).toStep(4)
        val edited = ScenarioJson.read(path.resolve("scenario.json"), listOf("output.modes=9"))
        Files.writeString(path.resolve("scenario.json"), ScenarioJson.write(edited))
        val e = assertThrows(InputException::class.java) { Run.resume(path).close() }
        assertTrue("output.modes" in e.message.orEmpty()) { e.message }
    }
}
