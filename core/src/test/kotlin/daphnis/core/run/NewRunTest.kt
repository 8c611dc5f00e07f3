package daphnis.core.run

import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/** How a run takes its directory: nothing goes before all is known to be fine, and one run at a time writes. */
class NewRunTest {
    @TempDir
    lateinit var home: Path

    private val whole by lazy {
        startIn(home.resolve("whole")).toStep(Long.MAX_VALUE)
        results(home.resolve("whole"))
    }

    private fun refused(vararg parts: String, action: () -> Unit) {
        val message = assertThrows(InputException::class.java, action).message.orEmpty()
        for (part in parts) assertTrue(part in message) { message }
        assertFalse('\n' in message)
    }

    @Test
    fun `force into the directory of a live run is refused and changes nothing`() {
        val directory = home.resolve("live")
        startIn(directory).use { run ->
            run.execute(cancelled = { run.simulation.step >= 7 })
            val before = bytesIn(directory)
            refused("another process") { startIn(directory, force = true).close() }
            refused("another process") { Run.resume(directory) }
            assertEquals(before, bytesIn(directory))
        }
        Run.resume(directory).use { it.execute() }
        assertEquals(whole, results(directory))
    }

    @Test
    fun `what is refused with force leaves the run that is there`() {
        val directory = home.resolve("a")
        startIn(directory).toStep(7)
        val before = bytesIn(directory)
        refused("engine.name") { startIn(directory, tableScenario("engine.name=warp"), force = true) }
        refused("filling factor") { startIn(directory, tableScenario("box.lengths=[0.5,7,7]"), force = true) }
        for (n in 0..1) {
            val full = FullFiles(n, "No space left on device")
            assertThrows(RunException::class.java) { startIn(directory, force = true, files = full) }
            assertEquals(before, bytesIn(directory)) { "no space before operation $n" }
        }
        Run.resume(directory).use { it.execute() }
        assertEquals(whole, results(directory))
    }

    @Test
    fun `what is in the way of force is named before anything goes, and what others put beside the run stays`() {
        val directory = home.resolve("a")
        startIn(directory).toStep(7)
        for (name in listOf("summary.json", "report.html")) {
            Files.deleteIfExists(directory.resolve(name))
            Files.createDirectories(directory.resolve(name).resolve("inner"))
            val before = bytesIn(directory)
            refused("$name is a directory") { startIn(directory, force = true) }
            assertEquals(before, bytesIn(directory))
            Files.delete(directory.resolve(name).resolve("inner"))
            Files.delete(directory.resolve(name))
        }
        val elsewhere = Files.createDirectories(home.resolve("elsewhere"))
        val precious = Files.writeString(elsewhere.resolve("precious.csv"), "1")
        val link = Files.createSymbolicLink(directory.resolve("tables"), elsewhere)
        refused("tables is a link") { startIn(directory, force = true) }
        Files.delete(link)
        assertTrue(Files.exists(precious))
        val notes = Files.createDirectories(directory.resolve("plots/mine")).resolve("notes")
        Files.writeString(notes, "1")
        val text = Files.writeString(directory.resolve("snapshots/readme.txt"), "1")
        val unfinished = listOf("report.html.part", "plots/run.svg.part", "tables/numbers.csv.part").map {
            Files.createDirectories(directory.resolve(it).parent)
            Files.writeString(directory.resolve(it), "1")
        }
        startIn(directory, force = true).toStep(7)
        assertEquals(emptyList<Path>(), unfinished.filter { Files.exists(it) })
        assertTrue(Files.exists(notes) && Files.exists(text))
    }

    @Test
    fun `a start that has no space leaves no directory`() {
        val full = FullFiles(0, "No space left on device")
        val e = assertThrows(RunException::class.java) { startIn(home.resolve("none"), files = full) }
        assertTrue("No space left" in e.message.orEmpty()) { e.message }
        assertFalse(Files.exists(home.resolve("none")))
    }

    @Tag("thorough")
    @Test
    fun `a start with force that is killed between any two operations leaves the old run or the new start`() {
        val old = startIn(home.resolve("old"), tableScenario("seed=8")).toStep(Long.MAX_VALUE).stateDigest
        var n = 0
        var isThrough = false
        val seen = HashSet<String>()
        while (!isThrough) {
            val directory = home.resolve("killed-$n")
            startIn(directory, tableScenario("seed=8")).toStep(7)
            val files = MortalFiles(n)
            try {
                startIn(directory, force = true, files = files).close()
                isThrough = true
            } catch (e: Killed) {
                seen += if (Files.exists(directory.resolve("scenario.json"))) "old" else "cut short"
            }
            if (isThrough || !Files.exists(directory.resolve("scenario.json"))) {
                if (!isThrough) refused("cut short", "again") { Run.resume(directory) }
                startIn(directory, force = isThrough).toStep(Long.MAX_VALUE)
                assertEquals(whole, results(directory)) { "after ${files.operations}" }
            } else {
                val resumed = Run.resume(directory).use { it.execute() }
                val isNew = files.operations.lastOrNull() == "move scenario.json.tmp to scenario.json"
                assertEquals(if (isNew) whole["digest"] else old, resumed.stateDigest) { "after ${files.operations}" }
            }
            n++
        }
        assertEquals(setOf("old", "cut short"), seen)
        assertTrue(n > 10) { "$n operations" }
    }

    @Test
    fun `of many that start into one directory at once, one does`() {
        val directory = home.resolve("contested")
        startIn(directory, tableScenario("seed=8")).toStep(5)
        val results = java.util.concurrent.ConcurrentLinkedQueue<Any>()
        val threads = List(4) {
            thread {
                try {
                    startIn(directory, force = true).use { run -> results += run.execute().stateDigest }
                } catch (e: InputException) {
                    results += "refused"
                } catch (e: Throwable) {
                    results += e
                }
            }
        }
        for (thread in threads) thread.join(60_000)
        assertTrue(results.all { it == whole["digest"] || it == "refused" }) { results.toString() }
        assertTrue(whole["digest"] in results)
        assertEquals(whole, results(directory))
    }

    @Test
    fun `another process is kept out, also after this one was`() {
        val directory = home.resolve("guarded")
        startIn(directory).use {
            assertThrows(InputException::class.java) { Run.resume(directory) }
            assertEquals(REFUSED, probe(directory))
        }
        assertEquals(FREE, probe(directory))
    }

    private fun probe(directory: Path): Int {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val classes = System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")
        val process = ProcessBuilder(
            java,
            "-cp",
            classes,
            "daphnis.core.run.LockProbe",
            directory.toString(),
        ).inheritIO().start()
        assertTrue(process.waitFor(60, TimeUnit.SECONDS))
        return process.exitValue()
    }

    @Test
    fun `a directory by a link is the same directory`() {
        val real = Files.createDirectories(home.resolve("real"))
        val link = Files.createSymbolicLink(home.resolve("link"), real)
        startIn(link).use { run ->
            refused("another process") { startIn(real, force = true) }
            run.execute()
        }
        assertEquals(whole, results(real))
        Files.createSymbolicLink(home.resolve("dangling"), home.resolve("nothing"))
        refused("dangling", "link") { startIn(home.resolve("dangling")) }
        Files.writeString(home.resolve("file"), "precious")
        refused("no directory") { startIn(home.resolve("file"), force = true) }
    }

    @Test
    fun `a run that starts from its own directory's particle file may replace itself`() {
        val text = "x, y, z, vx, radius\n-2, 0, 0, 1, 0.5\n2,0.1,0,-1,0.5\n"
        val file = Files.writeString(home.resolve("two.csv"), text)
        fun scenario(path: Path) =
            tableScenario("placement={\"type\":\"file\",\"path\":\"$path\"}", "particles=null", "velocities=null")
        val first = startIn(home.resolve("self"), scenario(file)).toStep(Long.MAX_VALUE)
        val again = startIn(
            home.resolve("self"),
            scenario(home.resolve("self/initial.csv")),
            force = true,
        ).toStep(Long.MAX_VALUE)
        assertEquals(first.stateDigest, again.stateDigest)
        assertEquals(text, Files.readString(home.resolve("self/initial.csv")))
    }

    @Test
    fun `a directory without a run that is refused stays as it was`() {
        val directory = Files.createDirectories(home.resolve("mine"))
        Files.writeString(directory.resolve("thesis.txt"), "precious")
        refused("not empty") { startIn(directory) }
        refused("holds no run") { startIn(directory, force = true) }
        assertEquals(
            listOf("thesis.txt"),
            Files.list(directory).use { files ->
                files.map { it.fileName.toString() }.toList()
            },
        )
    }

    private companion object {
        const val FREE = 0
        const val REFUSED = 3
    }
}
