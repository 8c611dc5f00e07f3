package daphnis.analysis.report

import com.google.common.jimfs.Configuration
import com.google.common.jimfs.Jimfs
import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertArrayEquals
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

    /** Files of a run and its report, by their paths with `/`, and the digest of the last state. */
    private class Written(val digest: String, val files: Map<String, ByteArray>)

    private fun writtenIn(root: Path): Written {
        val run = root.resolve("my run")
        val report = root.resolve("my report")
        val scenario = BuiltIn.scenario("ring-patch", listOf("particles.opticalDepth=0.1", "output.snapshotEvery=4"))
        var last = 0L
        Run.builder(scenario).directory(run).steps(12).output("watch", { last = it.step }).cancelled { last >= 6 }.start()
            .use { it.execute() }
        val summary = Run.resuming(run).resume().use { it.execute() }
        Analysis(AnalysisInput.ofRun(run)).write(report)
        val files = Files.walk(root).use { all -> all.filter(Files::isRegularFile).toList() }
        val names = files.associateBy { root.relativize(it).joinToString("/") }
        return Written(summary.stateDigest, names.mapValues { Files.readAllBytes(it.value) }.toSortedMap())
    }

    @Test
    fun `the same bytes are written for every style of paths`() {
        val there = writtenIn(Files.createDirectory(home.resolve("there")))
        for ((style, root) in STYLES) {
            Jimfs.newFileSystem(style).use { system ->
                val here = writtenIn(Files.createDirectories(system.getPath(root)))
                assertEquals(there.digest, here.digest) { root }
                assertEquals(there.files.keys, here.files.keys) { root }
                for ((name, bytes) in here.files) {
                    if (OF_THIS_RUN.containsMatchIn(name)) continue
                    assertArrayEquals(there.files.getValue(name), bytes) { "$root: $name" }
                }
            }
        }
    }

    @Test
    fun `tables end their lines in one way`() {
        Jimfs.newFileSystem(Configuration.windows()).use { system ->
            val files = writtenIn(Files.createDirectories(system.getPath("C:\\w"))).files
            val texts = files.filterKeys { it.endsWith(".csv") || it.endsWith(".json") || it.endsWith(".html") }
            assertTrue(texts.size > 8) { "${texts.keys}" }
            assertEquals(emptySet<String>(), texts.filterValues { '\r'.code.toByte() in it }.keys)
        }
    }

    private companion object {
        val STYLES = listOf(
            Configuration.unix() to "/my work",
            Configuration.osX() to "/Users/me/My Work",
            Configuration.windows() to "C:\\Users\\me\\My Work",
        )

        /** With times of the clock, or the number of the process. */
        val OF_THIS_RUN = Regex("""/\.lock$|/checkpoint|/summary\.json$""")
    }
}
