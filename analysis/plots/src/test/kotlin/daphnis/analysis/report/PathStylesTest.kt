package daphnis.analysis.report

import com.google.common.jimfs.Configuration
import com.google.common.jimfs.Jimfs
import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/**
 * A run is written, resumed and analysed where paths look as on Linux, macOS and Windows, in memory: nothing leans on
 * `/`, on names that differ in case, or on the line ends of this system.
 */
class PathStylesTest {
    @TempDir
    lateinit var home: Path

    /** Files of a run and its report by their paths with `/`, each byte a letter, and the digest of the last state. */
    private class Written(val digest: String, val files: Map<String, String>)

    private fun writtenIn(root: Path): Written {
        val run = root.resolve("my run")
        val report = root.resolve("my report")
        val scenario = BuiltIn.scenario("cooling-gas", listOf("particles.count=100", "output.snapshotEvery=4"))
        var last = 0L
        Run.builder(scenario).directory(run).steps(12).output("watch", {
            last = it.step
        }).cancelled { last >= 6 }.start()
            .use { it.execute() }
        val summary = Run.resuming(run).resume().use { it.execute() }
        Analysis(AnalysisInput.ofRun(run)).write(report)
        val files = Files.walk(root).use { all -> all.filter(Files::isRegularFile).toList() }
        val names = files.associateBy { root.relativize(it).joinToString("/") }
        // The report names the run by its whole path, in commands, and says how long it took.
        val separator = root.fileSystem.separator
        val texts = names.mapValues { (_, file) ->
            String(Files.readAllBytes(file), Charsets.ISO_8859_1)
                .replace("$root$separator", "/").replace("my run$separator", "my run/").replace(TOOK, "")
        }
        return Written(summary.stateDigest, texts.toSortedMap())
    }

    @Test
    fun `the same bytes are written for every style of paths`() {
        val there = writtenIn(Files.createDirectory(home.resolve("there")))
        for ((style, root) in STYLES) {
            Jimfs.newFileSystem(style).use { system ->
                val here = writtenIn(Files.createDirectories(system.getPath(root)))
                assertEquals(there.digest, here.digest) { root }
                assertEquals(there.files.keys, here.files.keys) { root }
                assertTrue(here.files.keys.count(TEXT::containsMatchIn) > 8) { "${here.files.keys}" }
                for ((name, text) in here.files) {
                    if (OF_THIS_RUN.containsMatchIn(name)) continue
                    assertEquals("", difference(there.files.getValue(name), text)) { "$root: $name" }
                    assertTrue('\r' !in text || !TEXT.containsMatchIn(name)) { "$root: $name" }
                }
            }
        }
    }

    /** Where [a] and [b] first differ, and what is there; empty when they are the same. */
    private fun difference(a: String, b: String): String {
        if (a == b) return ""
        val at = a.commonPrefixWith(b).length
        return listOf(a, b).joinToString(" <> ") { it.substring(maxOf(0, at - AROUND), minOf(it.length, at + AROUND)) }
    }

    private companion object {
        const val AROUND = 60
        val STYLES = listOf(
            Configuration.unix() to "/my work",
            Configuration.osX() to "/Users/me/My Work",
            Configuration.windows() to "C:\\Users\\me\\My Work",
        )

        /** With times of the clock, or the number of the process. */
        val OF_THIS_RUN = Regex("""/\.lock$|/checkpoint|/summary\.json$""")
        val TOOK = Regex("""(?<=threads?), [\d.]+ s(?=</td>)""")
        val TEXT = Regex("""\.(csv|json|html|svg)$""")
    }
}
