package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class NewFilesTest {
    @TempDir
    lateinit var folder: Path

    /** All files below [path] with what they hold, but for their list. */
    private fun files(path: Path): Map<String, String> = Files.walk(path).use { all ->
        all.filter { Files.isRegularFile(it) && !it.endsWith(NewFiles.LIST) }.toList().associate {
            "${path.relativize(it)}" to Files.readString(it, Charsets.ISO_8859_1)
        }
    }

    @Test
    fun `files appear together when they are kept, in the place of those that were there`() {
        Files.writeString(folder.resolve("report.html"), "before")
        Files.writeString(Files.createDirectory(folder.resolve("plots")).resolve("run.svg"), "of the run")
        NewFiles(folder).use { new ->
            Files.writeString(new.place.resolve("report.html"), "after")
            Files.writeString(Files.createDirectory(new.place.resolve("plots")).resolve("a.svg"), "a")
            assertEquals("before", Files.readString(folder.resolve("report.html")))
            assertFalse(Files.exists(folder.resolve("plots/a.svg")))
            new.keep()
        }
        val wanted = mapOf("report.html" to "after", "plots/a.svg" to "a", "plots/run.svg" to "of the run")
        assertEquals(wanted, files(folder))
        assertEquals(3, Files.list(folder).use { it.count() })
    }

    @Test
    fun `files that were kept before go, and no others, wherever their list leads`() {
        val elsewhere = Files.createDirectory(folder.resolve("elsewhere"))
        Files.writeString(elsewhere.resolve("precious.csv"), "precious")
        val out = folder.resolve("deep/out")
        fun keep(vararg names: String) = NewFiles(out).use { new ->
            for (name in names) {
                val file = new.place.resolve(name)
                Files.createDirectories(file.parent)
                Files.writeString(file, name)
            }
            new.keep()
        }
        keep("report.html", "tables/a.csv", "tables/b.csv", "plots/b.svg")
        Files.writeString(out.resolve("tables/own.csv"), "of the user")
        val list = out.resolve(NewFiles.LIST)
        Files.writeString(list, Files.readString(list) + "../../elsewhere/precious.csv\n$elsewhere/precious.csv\n\n")
        keep("report.html", "tables/a.csv", "tables/c.csv")
        assertEquals(setOf("report.html", "tables/a.csv", "tables/c.csv", "tables/own.csv"), files(out).keys)
        assertEquals(listOf("report.html", "tables/a.csv", "tables/c.csv"), Files.readAllLines(list))
        assertEquals("precious", Files.readString(elsewhere.resolve("precious.csv")))
    }

    @Test
    fun `what is not kept leaves nothing behind, and no empty directory`() {
        val empty = Files.createDirectory(folder.resolve("empty"))
        NewFiles(empty).use { Files.writeString(it.place.resolve("report.html"), "half") }
        assertFalse(Files.exists(empty))
        Files.writeString(folder.resolve("report.html"), "before")
        NewFiles(folder).use { Files.createDirectories(it.place.resolve("plots/deep")) }
        assertEquals(mapOf("report.html" to "before"), files(folder))
    }

    @Test
    fun `what a killed process left is taken away, and nothing that is written to or only so called`() {
        val left = Files.createDirectories(folder.resolve(".analysis-1/plots"))
        Files.writeString(left.resolve("half.svg"), "half")
        Files.writeString(left.resolveSibling(".lock"), "1\n")
        val elsewhere = Files.createDirectories(folder.resolve("elsewhere"))
        Files.writeString(elsewhere.resolve("precious"), "precious")
        val link = Files.createSymbolicLink(folder.resolve(".analysis-2"), elsewhere)
        Files.createSymbolicLink(left.resolve("inner"), elsewhere)
        val file = Files.writeString(folder.resolve(".analysis-3"), "a file")
        NewFiles(folder).use { first ->
            assertFalse(Files.exists(left.parent))
            Files.writeString(first.place.resolve("report.html"), "first")
            NewFiles(folder).use { second ->
                assertTrue(Files.exists(first.place.resolve("report.html")))
                second.keep()
            }
            assertTrue(Files.exists(first.place))
            first.keep()
        }
        assertEquals(setOf("report.html", "elsewhere/precious", ".analysis-3"), files(folder).keys)
        assertTrue(Files.exists(link) && Files.exists(file))
    }

    @Test
    fun `a directory in which another process writes stays until that process is killed`() {
        val held = Files.createDirectory(folder.resolve(".analysis-9"))
        val process = LockHolder.start(held)
        try {
            NewFiles(folder).close()
            assertTrue(Files.exists(held))
        } finally {
            process.destroyForcibly().waitFor()
        }
        NewFiles(folder).close()
        assertFalse(Files.exists(held))
    }

    private fun run(name: String): Path {
        val path = folder.resolve(name).resolve("run")
        val settings = listOf("untilOrbits=1", "box.lengths=[40,40,20]", "output.snapshotEvery=50")
        Run.start(BuiltIn.scenario("ring-patch", settings), name, path).use { it.execute() }
        return path
    }

    @Test
    fun `reports of two equal runs are the same bytes, and one that breaks off leaves the one before whole`() {
        val (first, second) = listOf("a", "b").map(::run)
        for (path in listOf(first, second)) Analysis(AnalysisInput.ofRun(path)).write(path)
        for (part in listOf("tables", "plots")) {
            val found = files(second.resolve(part)).toList()
            assertTrue(found.size > 10)
            assertEquals(files(first.resolve(part)).keys, found.map { it.first }.toSet())
            for ((name, bytes) in found) assertEquals(files(first.resolve(part))[name], bytes) { "$part/$name" }
        }
        val reports = listOf(first, second).map { Files.readString(it.resolve("report.html")).replace("$it", "RUN") }

        // With how many seconds it took.
        fun timeless(page: String) = page.lines().filter { ">engine<" !in it }
        assertTrue(timeless(reports[0]) == timeless(reports[1]))
        val before = files(second)
        for (stop in 0..3) {
            var told = 0
            assertThrows(IllegalStateException::class.java) {
                Analysis(AnalysisInput.ofRun(second)).write(second) { _, _, _ -> check(told++ < stop) { "broken off" } }
            }
            assertEquals(before, files(second))
        }
        assertArrayEquals(arrayOf(), Files.list(second).use { all -> all.filter { ".analysis" in "$it" }.toArray() })
    }
}
