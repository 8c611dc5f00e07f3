package daphnis.core.run

import daphnis.core.input.InputException
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** A directory that somebody else prepared must not lead what is written there elsewhere. */
class LinksTest {
    @TempDir
    lateinit var home: Path

    private val scenario = BuiltIn.scenario("cooling-gas", listOf("particles.count=20", "output.snapshotEvery=2"))

    private fun start(path: Path) = Run.start(scenario, "links", path)

    private fun refusal(what: () -> Unit): String =
        assertThrows(InputException::class.java) { what() }.message.orEmpty().also { assertTrue('\n' !in it) { it } }

    @Test
    fun `a link to a file is refused before anything is written, whatever it is called, and its target stays`() {
        val precious = Files.writeString(home.resolve("precious"), "precious")
        val names = listOf(".lock", "scenario.json.tmp", "scenario.json", "series.csv", "checkpoint.new")
        for ((k, name) in names.withIndex()) {
            val directory = Files.createDirectories(home.resolve("$k"))
            Files.createSymbolicLink(directory.resolve(name), precious)
            refusal { start(directory).close() }
            assertEquals("precious", Files.readString(precious)) { name }
            assertEquals(1, Files.list(directory).use { it.count() }) { "$name: nothing is beside it" }
        }
    }

    @Tag("thorough")
    @Test
    fun `so it is where a run is resumed, also in its subdirectories, and where there is no target`() {
        val directory = home.resolve("a")
        start(directory).toStep(5)
        for (name in listOf("series.csv", "snapshots/0000000006.h5", "summary.json.tmp")) {
            val target = home.resolve("target")
            val link = directory.resolve(name)
            val kept = home.resolve("kept")
            if (Files.exists(link)) Files.move(link, kept)
            Files.createSymbolicLink(link, target)
            val message = refusal { Run.resume(directory).close() }
            assertTrue("$link: is a link" in message) { message }
            assertTrue(Files.notExists(target))
            Files.delete(link)
            if (Files.exists(kept)) Files.move(kept, link)
        }
        Run.resume(directory).use { it.execute() }
    }

    @Test
    fun `a link that comes later is not followed either`() {
        val precious = Files.writeString(home.resolve("precious"), "precious")
        val link = Files.createSymbolicLink(home.resolve("table.csv"), precious)
        assertThrows(IOException::class.java) {
            AppendedFile(link, "x", null, FileOperations(), DirectWriter).close()
        }
        val beside = Files.createSymbolicLink(home.resolve("new.tmp"), precious)
        FileOperations().writeAtomically(home.resolve("new")) { Files.writeString(it, "new") }
        assertEquals("new", Files.readString(home.resolve("new")))
        assertTrue(Files.notExists(beside))
        assertEquals("precious", Files.readString(precious))
    }

    @Test
    fun `a file of the name of the lock that holds more than the number of a process is not overwritten`() {
        for (text in listOf("precious", "12 precious", "123456789012345678901")) {
            val directory = Files.createDirectories(home.resolve(text))
            val file = Files.writeString(directory.resolve(".lock"), text)
            val message = refusal { start(directory).close() }
            assertTrue("$file: holds no number of a process" in message) { message }
            assertEquals(text, Files.readString(file))
        }
    }

    @Test
    fun `a hard link in the place of the lock is refused, and one in that of a file to come is replaced`() {
        val precious = Files.writeString(home.resolve("precious"), "precious")
        for ((k, name) in listOf(".lock", "scenario.json.tmp").withIndex()) {
            val directory = Files.createDirectories(home.resolve("$k"))
            Files.createLink(directory.resolve(name), precious)
            if (k == 0) {
                val message = refusal { start(directory).close() }
                assertTrue("$directory/.lock: holds no number of a process" in message) { message }
            } else {
                start(directory).close()
            }
            assertEquals("precious", Files.readString(precious)) { name }
        }
    }

    @Test
    fun `a link in the place of the lock is refused also when a directory is its target`() {
        for (name in RunLock.FILES) {
            val directory = Files.createDirectories(home.resolve("a$name"))
            Files.createSymbolicLink(directory.resolve(name), Files.createDirectories(home.resolve("b$name")))
            val message = refusal { start(directory).close() }
            assertTrue("$directory/$name: is a link" in message) { message }
        }
    }

    @Tag("thorough")
    @Test
    fun `directories may be links of one's own`() {
        val elsewhere = Files.createDirectories(home.resolve("elsewhere"))
        val link = Files.createSymbolicLink(home.resolve("link"), elsewhere)
        start(link).toStep(5)
        val moved = Files.move(elsewhere.resolve("snapshots"), home.resolve("disk"))
        Files.createSymbolicLink(elsewhere.resolve("snapshots"), moved)
        Run.resume(link).use { it.execute() }
        assertTrue(Files.exists(home.resolve("disk/0000000006.h5")))
    }

    @Test
    fun `what is moved into its place may take that of a link`() {
        Files.createSymbolicLink(home.resolve("report.html"), home.resolve("target"))
        Links.check(home, replaces = true)
        refusal { Links.check(home) }
    }
}
